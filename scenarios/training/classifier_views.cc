#include "scenarios/training/classifier_views.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::training {
namespace {

using models::RandomStream;

constexpr double kMinHeight_m = 0.06;
constexpr double kLowContrast = 0.6;
constexpr double kClearance_m = 0.05;
constexpr double kMinRayCosine = 0.35;  ///< Cosine of the angle between the ray to the target and the floor normal.

/// R_WC of a camera that looks down, rotated by `yaw`, then tilted by `tilt` about the horizontal axis at `direction`.
Eigen::Matrix3d LookDown(double yaw, double tilt, double direction) {
  const Eigen::Matrix3d R_WC_down = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0.0);
  return models::RotationExp(tilt * axis) * models::RotationExp(yaw * Eigen::Vector3d::UnitZ()) * R_WC_down;
}

bool IsInsideSolid(const sim::Scene& scene, const Eigen::Vector3d& p_W) {
  return std::any_of(scene.items.begin(), scene.items.end(), [&](const sim::SceneItem& item) {
    if (item.IsFlat() || p_W.z() > item.size_m.z() + kClearance_m) return false;
    return (p_W.head<2>() - item.position_m).norm() < 0.5 * item.size_m.head<2>().norm() + kClearance_m;
  });
}

double LogUniform(double low, double high, RandomStream& random) {
  return std::exp(random.Uniform(std::log(low), std::log(high)));
}

/// Draws a pixel at which a target with radius `radius_px` fits in the image if possible.
Eigen::Vector2d DrawPixel(const models::CameraModel& camera, double radius_px, RandomStream& random) {
  const double u_margin = std::min(1.1 * radius_px, 0.5 * camera.width_px);
  const double v_margin = std::min(1.1 * radius_px, 0.5 * camera.height_px);
  const double u = random.Uniform(u_margin, camera.width_px - u_margin);
  const double v = random.Uniform(v_margin, camera.height_px - v_margin);
  return {u - 0.5, v - 0.5};
}

/// Draws R_WC of a hovering camera, aligned with one of the axes of the target.
Eigen::Matrix3d DrawHoverRotation(const GroundShape& target, RandomStream& random) {
  constexpr double kAlong_deg = 1.5, kLevel_deg = 3.0;
  const double yaw =
      target.yaw + random.UniformInt(0, 3) * models::kPi / 2.0 + models::DegToRad(kAlong_deg) * random.Normal();
  const double tilt = models::DegToRad(kLevel_deg) * random.Uniform();
  return LookDown(yaw, tilt, random.Uniform(-models::kPi, models::kPi));
}

/// Draws R_WC of a camera that looks down with random heading and tilt.
Eigen::Matrix3d DrawTiltedRotation(double max_tilt_deg, RandomStream& random) {
  const double tilt = models::DegToRad(max_tilt_deg) * random.Uniform();
  const double yaw = random.Uniform(-models::kPi, models::kPi), direction = random.Uniform(-models::kPi, models::kPi);
  return LookDown(yaw, tilt, direction);
}

Eigen::Isometry3d DrawPose(const ViewConfig& config, bool hovering, const sim::Scene& scene, const GroundShape& target,
                           const models::CameraModel& camera, RandomStream& random) {
  while (true) {
    const double distance = LogUniform(config.min_distance_m, config.max_distance_m, random);
    const Eigen::Matrix3d R_WC =
        hovering ? DrawHoverRotation(target, random) : DrawTiltedRotation(config.max_tilt_deg, random);
    const Eigen::Vector2d pixel = DrawPixel(camera, camera.fx_px * target.radius_m / distance, random);
    const std::optional<Eigen::Vector3d> ray_C = camera.Ray(pixel);
    if (!ray_C) continue;
    const Eigen::Vector3d ray_W = R_WC * *ray_C;
    const Eigen::Vector3d p_WC = Eigen::Vector3d(target.position_m.x(), target.position_m.y(), 0.0) - distance * ray_W;
    if (-ray_W.z() < kMinRayCosine || p_WC.z() < kMinHeight_m || IsInsideSolid(scene, p_WC)) continue;
    Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
    X_WC.linear() = R_WC;
    X_WC.translation() = p_WC;
    return X_WC;
  }
}

}  // namespace

void ViewConfig::Validate() const {
  const bool ranges = min_distance_m > 0.0 && max_distance_m >= min_distance_m && std::isfinite(max_distance_m) &&
                      max_tilt_deg >= 0.0 && max_tilt_deg < 80.0 && min_exposure_s > 0.0 &&
                      max_exposure_s >= min_exposure_s && std::isfinite(max_exposure_s);
  const bool effects = hovering_fraction >= 0.0 && hovering_fraction <= 1.0 && speed_scale_m_s >= 0.0 &&
                       rate_scale_rad_s >= 0.0 && max_defocus_px >= 0.0 && !noise_sigmas.empty() &&
                       min_contrast > 0.0 && min_contrast <= 1.0;
  if (!ranges || !effects) throw InputError("training set: invalid range of the views");
}

Eigen::Isometry3d View::PoseAt(double offset_s) const {
  Eigen::Isometry3d X = X_WC;
  X.translation() += offset_s * v_WC;
  X.linear() = X_WC.linear() * models::RotationExp(offset_s * w_WC_C);
  return X;
}

View DrawView(const ViewConfig& config, const sim::Scene& scene, const GroundShape& target,
              const models::CameraModel& camera, RandomStream& random) {
  const bool hovering = random.Bernoulli(config.hovering_fraction);
  View view{.X_WC = DrawPose(config, hovering, scene, target, camera, random)};
  view.exposure_s = LogUniform(config.min_exposure_s, config.max_exposure_s, random);
  if (!hovering) {
    view.v_WC = random.Uniform() * config.speed_scale_m_s * random.NormalVector3() / std::sqrt(3.0);
    view.w_WC_C = random.Uniform() * config.rate_scale_rad_s * random.NormalVector3() / std::sqrt(3.0);
    view.defocus_px = random.Bernoulli(0.5) ? config.max_defocus_px * random.Uniform() : 0.0;
  }
  view.contrast = random.Bernoulli(0.5) ? random.Uniform(config.min_contrast, 1.0) : 1.0;
  const int levels = static_cast<int>(config.noise_sigmas.size());
  view.noise_level = random.UniformInt(0, view.contrast < kLowContrast && levels > 1 ? levels - 2 : levels - 1);
  view.brightness = random.Uniform(0.0, 120.0) * (1.0 - view.contrast);
  return view;
}

double MotionBlur(const View& view, const GroundShape& target, const models::CameraModel& camera) {
  const Eigen::Vector3d p_W(target.position_m.x(), target.position_m.y(), 0.0);
  const auto begin = camera.Project(view.PoseAt(-0.5 * view.exposure_s).inverse() * p_W);
  const auto end = camera.Project(view.PoseAt(0.5 * view.exposure_s).inverse() * p_W);
  return begin && end ? (*end - *begin).norm() : 0.0;
}

}  // namespace touchdown::training
