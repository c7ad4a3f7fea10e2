#include "scenarios/experiments/circle_limit.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "models/angles.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

/// X_WC translated in W by the first three elements of `step`, m, and rotated about W's X and Y axes by the last two,
/// rad.
Eigen::Isometry3d Moved(const Eigen::Isometry3d& X_WC, const Vector5d& step) {
  Eigen::Isometry3d moved = X_WC;
  moved.translation() += step.head<3>();
  moved.linear() = models::RotationExp(Vector3d(step[3], step[4], 0.0)) * X_WC.linear();
  return moved;
}

}  // namespace

std::optional<CircleLimit> LimitForCircle(const models::CameraModel& camera, double radius_m,
                                          const Eigen::Isometry3d& X_WC, double noise_fraction) {
  constexpr int kPoints = 720;
  constexpr double kStep = 1e-6;
  const auto on_edge = [&](int i) {
    const double angle = 2.0 * models::kPi * i / kPoints;
    return Vector3d(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0);
  };
  const auto pixel = [&](const Vector3d& p_W, const Eigen::Isometry3d& X) { return camera.Project(X.inverse() * p_W); };
  Matrix5d information = Matrix5d::Zero();
  for (int i = 0; i < kPoints; ++i) {
    const auto before = pixel(on_edge(i - 1), X_WC), after = pixel(on_edge(i + 1), X_WC);
    if (!before || !after) return std::nullopt;
    const Vector2d chord = *after - *before;
    const Vector2d normal = Vector2d(-chord.y(), chord.x()).normalized();
    const double length_px = 0.5 * chord.norm();
    Vector5d motion;
    for (int k = 0; k < 5; ++k) {
      const Vector5d step = kStep * Vector5d::Unit(k);
      const auto forth = pixel(on_edge(i), Moved(X_WC, step)), back = pixel(on_edge(i), Moved(X_WC, -step));
      if (!forth || !back) return std::nullopt;
      motion[k] = normal.dot(*forth - *back) / (2.0 * kStep);
    }
    information += length_px / (noise_fraction * noise_fraction) * motion * motion.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix5d> solved(information);
  constexpr double kSingular = 1e-9;
  if (solved.eigenvalues()[0] < kSingular * solved.eigenvalues()[4]) return std::nullopt;
  const Matrix5d covariance = information.inverse();
  return CircleLimit{.position_m = std::sqrt(covariance.topLeftCorner<3, 3>().trace()),
                     .tilt_rad = std::sqrt(covariance.bottomRightCorner<2, 2>().trace())};
}

}  // namespace touchdown::experiments
