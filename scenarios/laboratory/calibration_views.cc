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
constexpr double kMaxTilt_deg = 45.0;
constexpr double kMaxDistanceFactor = 1.25;
constexpr double kDistanceStep = 1.03;
constexpr int kMaxAttempts = 200;

/// Draws a rotation R_EC with `ray_C` within kMaxTilt_deg of the board normal, and a uniform rotation about the ray.
Matrix3d DrawRotation(const Vector3d& ray_C, models::RandomStream& random) {
  const double heading = random.Uniform(-models::kPi, models::kPi), spin = random.Uniform(-models::kPi, models::kPi);
  const double tilt = models::DegToRad(kMaxTilt_deg) * std::sqrt(random.Uniform());
  const Matrix3d looking_down = Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return models::RotationExp(tilt * Vector3d(std::cos(heading), std::sin(heading), 0.0)) *
         models::RotationExp(spin * Vector3d::UnitZ()) * looking_down *
         models::ShortestRotation(ray_C, Vector3d::UnitZ());
}

/// Offset of the board center from the image center, as fractions of half the image width and height.
Vector2d GridOffset(int view) {
  constexpr double kOffset = 0.35;
  const int cell = view % 9;
  return kOffset * Vector2d(cell % 3 - 1, cell / 3 - 1);
}

bool ShowsWholeBoard(const Chessboard& board, const models::CameraModel& camera, const Isometry3d& X_EC) {
  const Isometry3d X_CE = X_EC.inverse();
  const auto is_visible = [&](const Vector3d& p_E) {
    const std::optional<Vector2d> pixel = camera.Project(X_CE * p_E);
    return pixel && pixel->x() > kMargin_px && pixel->y() > kMargin_px &&
           pixel->x() < camera.width_px - 1 - kMargin_px && pixel->y() < camera.height_px - 1 - kMargin_px;
  };
  const std::vector<Vector3d> outer = board.OuterCorners();
  return std::all_of(outer.begin(), outer.end(), is_visible);
}

/// Camera pose with the board center on the ray at distance `distance_m`.
Isometry3d CameraPose(const Matrix3d& R_EC, const Vector3d& ray_C, double distance_m) {
  Isometry3d X_EC = Isometry3d::Identity();
  X_EC.linear() = R_EC;
  X_EC.translation() = -distance_m * (R_EC * ray_C);
  return X_EC;
}

/// Smallest distance, in steps of 3 %, at which the whole board is visible; nullopt when there is none in the range.
std::optional<double> MinDistance(const Chessboard& board, const models::CameraModel& camera, const Matrix3d& R_EC,
                                  const Vector3d& ray_C) {
  const double size_m = 2.0 * board.half_size_m().norm();
  const double max_distance_m = 10.0 * size_m * std::max(1.0, camera.fx_px / camera.width_px);
  for (double distance_m = 0.3 * size_m; distance_m < max_distance_m; distance_m *= kDistanceStep) {
    if (ShowsWholeBoard(board, camera, CameraPose(R_EC, ray_C, distance_m))) return distance_m;
  }
  return std::nullopt;
}

Isometry3d DrawView(const Chessboard& board, const models::CameraModel& camera, const Vector2d& offset,
                    models::RandomStream& random) {
  const Vector2d half_image(0.5 * (camera.width_px - 1), 0.5 * (camera.height_px - 1));
  for (int i = 0; i < kMaxAttempts; ++i) {
    const Vector2d jitter(random.Uniform(-0.15, 0.15), random.Uniform(-0.15, 0.15));
    const double distance_factor = random.Uniform(1.0, kMaxDistanceFactor);
    const auto ray = camera.Ray(half_image + half_image.cwiseProduct(offset + jitter));
    if (!ray) continue;
    const Matrix3d R_EC = DrawRotation(*ray, random);
    const auto min_distance_m = MinDistance(board, camera, R_EC, *ray);
    if (!min_distance_m) continue;
    const Isometry3d X_EC = CameraPose(R_EC, *ray, distance_factor * *min_distance_m);
    if (ShowsWholeBoard(board, camera, X_EC)) return X_EC;
  }
  throw InputError("camera.model: found no view that shows the whole calibration pattern");
}

}  // namespace

std::vector<Isometry3d> DrawCalibrationViews(const Chessboard& board, const models::CameraModel& camera, int count,
                                             models::RandomStream& random) {
  std::vector<Isometry3d> views;
  for (int i = 0; i < count; ++i) views.push_back(DrawView(board, camera, GridOffset(i), random));
  return views;
}

}  // namespace touchdown::laboratory
