#include "scenarios/laboratory/calibration_views.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::laboratory {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMargin_px = 4.0;
constexpr double kLargestTilt_deg = 45.0;
constexpr double kFarther = 1.25;
constexpr double kStep = 1.03;
constexpr int kTries = 200;

/// A rotation R_EC that has `ray_C` look at the board squarely but for a tilt, turned anyhow about it.
Matrix3d DrawRotation(const Vector3d& ray_C, models::RandomStream& random) {
  const double heading = random.Uniform(-models::kPi, models::kPi), turn = random.Uniform(-models::kPi, models::kPi);
  const double tilt = models::DegToRad(kLargestTilt_deg) * std::sqrt(random.Uniform());
  const Matrix3d looking_down = Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return models::RotationExp(tilt * Vector3d(std::cos(heading), std::sin(heading), 0.0)) *
         models::RotationExp(turn * Vector3d::UnitZ()) * looking_down *
         models::ShortestRotation(ray_C, Vector3d::UnitZ());
}

/// Places of the board's center in the image, as shares of its half width and height: the center, edges and corners.
Vector2d ShareOf(int view) {
  constexpr double kAside = 0.35;
  const int place = view % 9;
  return kAside * Vector2d(place % 3 - 1, place / 3 - 1);
}

bool ShowsWhole(const Chessboard& board, const models::CameraModel& camera, const Isometry3d& X_EC) {
  const Isometry3d X_CE = X_EC.inverse();
  const auto shows = [&](const Vector3d& p_E) {
    const std::optional<Vector2d> pixel = camera.Project(X_CE * p_E);
    return pixel && pixel->x() > kMargin_px && pixel->y() > kMargin_px &&
           pixel->x() < camera.width_px - 1 - kMargin_px && pixel->y() < camera.height_px - 1 - kMargin_px;
  };
  const std::vector<Vector3d> outer = board.OuterCorners();
  return std::all_of(outer.begin(), outer.end(), shows);
}

/// From where the board's center lies on the ray, `distance_m` away.
Isometry3d Looking(const Matrix3d& R_EC, const Vector3d& ray_C, double distance_m) {
  Isometry3d X_EC = Isometry3d::Identity();
  X_EC.linear() = R_EC;
  X_EC.translation() = -distance_m * (R_EC * ray_C);
  return X_EC;
}

/// The shortest distance at which the board is seen whole, by steps; nullopt when it is not up to many times its size.
std::optional<double> NearestDistance(const Chessboard& board, const models::CameraModel& camera, const Matrix3d& R_EC,
                                      const Vector3d& ray_C) {
  const double size_m = 2.0 * board.half_size_m().norm();
  const double farthest_m = 10.0 * size_m * std::max(1.0, camera.fx_px / camera.width_px);
  for (double distance_m = 0.3 * size_m; distance_m < farthest_m; distance_m *= kStep) {
    if (ShowsWhole(board, camera, Looking(R_EC, ray_C, distance_m))) return distance_m;
  }
  return std::nullopt;
}

Isometry3d DrawView(const Chessboard& board, const models::CameraModel& camera, const Vector2d& share,
                    models::RandomStream& random) {
  const Vector2d half_image(0.5 * (camera.width_px - 1), 0.5 * (camera.height_px - 1));
  for (int i = 0; i < kTries; ++i) {
    const Vector2d jitter(random.Uniform(-0.15, 0.15), random.Uniform(-0.15, 0.15));
    const double farther = random.Uniform(1.0, kFarther);
    const auto ray = camera.Ray(half_image + half_image.cwiseProduct(share + jitter));
    if (!ray) continue;
    const Matrix3d R_EC = DrawRotation(*ray, random);
    const auto nearest_m = NearestDistance(board, camera, R_EC, *ray);
    if (!nearest_m) continue;
    const Isometry3d X_EC = Looking(R_EC, *ray, farther * *nearest_m);
    if (ShowsWhole(board, camera, X_EC)) return X_EC;
  }
  throw InputError("camera.model: its lens does not show a calibration pattern whole from anywhere");
}

}  // namespace

std::vector<Isometry3d> DrawCalibrationViews(const Chessboard& board, const models::CameraModel& camera, int count,
                                             models::RandomStream& random) {
  std::vector<Isometry3d> views;
  for (int i = 0; i < count; ++i) views.push_back(DrawView(board, camera, ShareOf(i), random));
  return views;
}

}  // namespace touchdown::laboratory
