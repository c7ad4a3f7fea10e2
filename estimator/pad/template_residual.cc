#include "estimator/pad/template_residual.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/pad_outline.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

/// Points of the normalized image, laid onto the plane of `pose`, from the circle's center, in axes of the plane.
std::vector<Vector2d> OnPlane(std::span<const Vector2d> points, const CirclePose& pose) {
  const Eigen::Matrix3d plane_from_camera = models::ShortestRotation(pose.n_C, Eigen::Vector3d::UnitZ());
  const double distance = pose.n_C.dot(pose.p_CW);
  std::vector<Vector2d> laid;
  laid.reserve(points.size());
  for (const Vector2d& point : points) {
    const Eigen::Vector3d ray = point.homogeneous();
    laid.push_back((plane_from_camera * (distance / pose.n_C.dot(ray) * ray - pose.p_CW)).head<2>());
  }
  return laid;
}

/// Sum of squares of the H's points from its outline when its X axis lies at `angle` in the plane.
double LetterSquares(const std::vector<Vector2d>& points, double angle, const models::PadOutline& outline,
                     double farthest_m) {
  const Eigen::Rotation2Dd to_pad(-angle);
  double sum = 0.0;
  for (const Vector2d& point : points) {
    const double distance = std::min(farthest_m, outline.DistanceFromLetter(to_pad * point));
    sum += distance * distance;
  }
  return sum;
}

/// The smallest LetterSquares over all angles: a coarse look around the half circle, then ever finer about the best.
double BestLetterSquares(const std::vector<Vector2d>& points, const models::PadOutline& outline, double farthest_m) {
  constexpr int kCoarseAngles = 36;
  double best_angle = 0.0, best = LetterSquares(points, 0.0, outline, farthest_m);
  const auto look_at = [&](double angle) {
    const double squares = LetterSquares(points, angle, outline, farthest_m);
    if (squares >= best) return;
    best = squares;
    best_angle = angle;
  };
  const double coarse_step = models::kPi / kCoarseAngles;
  for (int i = 1; i < kCoarseAngles; ++i) look_at(i * coarse_step);
  constexpr double kFinest = 1e-4;
  for (double step = 0.5 * coarse_step; step > kFinest; step *= 0.5) {
    const double center = best_angle;
    look_at(center - step);
    look_at(center + step);
  }
  return best;
}

}  // namespace

TemplateResidual ResidualOfTemplate(std::span<const Vector2d> ring_inner, std::span<const Vector2d> letter,
                                    const models::LandingPad& pad, const CirclePose& pose) {
  const double farthest_m = 0.5 * pad.h_stroke_m;
  double squares = BestLetterSquares(OnPlane(letter, pose), models::PadOutline(pad), farthest_m);
  for (const Vector2d& point : OnPlane(ring_inner, pose)) {
    const double distance = std::min(std::abs(point.norm() - pad.inner_radius_m()), farthest_m);
    squares += distance * distance;
  }
  const std::size_t points = ring_inner.size() + letter.size();
  if (points == 0) return {};
  return {std::sqrt(squares / static_cast<double>(points)), points};
}

double WrongBranchProbability(const TemplateResidual& smaller, const TemplateResidual& larger) {
  if (smaller.points == 0 || larger.rms_m <= 0.0) return 0.5;
  constexpr double kIndependentPoints = 10.0;
  constexpr double kLeastRms_m = 1e-9;
  return 1.0 / (1.0 + std::pow(larger.rms_m / std::max(smaller.rms_m, kLeastRms_m), kIndependentPoints));
}

}  // namespace touchdown::estimator::pad
