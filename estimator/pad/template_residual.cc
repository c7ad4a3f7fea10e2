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

/// Points of the normalized image projected onto the plane of `pose`, relative to the circle's center, in axes of the
/// plane.
std::vector<Vector2d> OnPlane(std::span<const Vector2d> points, const CirclePose& pose) {
  const Eigen::Matrix3d plane_from_camera = models::ShortestRotation(pose.n_C, Eigen::Vector3d::UnitZ());
  const double distance = pose.n_C.dot(pose.p_CW);
  std::vector<Vector2d> projected;
  projected.reserve(points.size());
  for (const Vector2d& point : points) {
    const Eigen::Vector3d ray = point.homogeneous();
    projected.push_back((plane_from_camera * (distance / pose.n_C.dot(ray) * ray - pose.p_CW)).head<2>());
  }
  return projected;
}

/// Sum of the squared distances of the letter's points from its outline when its X axis is at `angle` in the plane.
double LetterSquares(const std::vector<Vector2d>& points, double angle, const models::PadOutline& outline,
                     double max_distance_m) {
  const Eigen::Rotation2Dd to_pad(-angle);
  double sum = 0.0;
  for (const Vector2d& point : points) {
    const double distance = std::min(max_distance_m, outline.DistanceFromLetter(to_pad * point));
    sum += distance * distance;
  }
  return sum;
}

/// Smallest LetterSquares over all angles, found by a coarse search over 180 degrees and repeated bisection of the
/// step.
double BestLetterSquares(const std::vector<Vector2d>& points, const models::PadOutline& outline,
                         double max_distance_m) {
  constexpr int kCoarseAngles = 36;
  double best_angle = 0.0, best = LetterSquares(points, 0.0, outline, max_distance_m);
  const auto try_angle = [&](double angle) {
    const double squares = LetterSquares(points, angle, outline, max_distance_m);
    if (squares >= best) return;
    best = squares;
    best_angle = angle;
  };
  const double coarse_step = models::kPi / kCoarseAngles;
  for (int i = 1; i < kCoarseAngles; ++i) try_angle(i * coarse_step);
  constexpr double kFinestStep = 1e-4;
  for (double step = 0.5 * coarse_step; step > kFinestStep; step *= 0.5) {
    const double center = best_angle;
    try_angle(center - step);
    try_angle(center + step);
  }
  return best;
}

}  // namespace

TemplateResidual ResidualOfTemplate(std::span<const Vector2d> ring_inner, std::span<const Vector2d> letter,
                                    const models::LandingPad& pad, const CirclePose& pose) {
  const double max_distance_m = 0.5 * pad.h_stroke_m;
  double squares = BestLetterSquares(OnPlane(letter, pose), models::PadOutline(pad), max_distance_m);
  for (const Vector2d& point : OnPlane(ring_inner, pose)) {
    const double distance = std::min(std::abs(point.norm() - pad.inner_radius_m()), max_distance_m);
    squares += distance * distance;
  }
  const std::size_t points = ring_inner.size() + letter.size();
  if (points == 0) return {};
  return {std::sqrt(squares / static_cast<double>(points)), points};
}

double WrongBranchProbability(const TemplateResidual& smaller, const TemplateResidual& larger) {
  if (smaller.points == 0 || larger.rms_m <= 0.0) return 0.5;
  constexpr double kIndependentPoints = 10.0;
  constexpr double kMinRms_m = 1e-9;
  return 1.0 / (1.0 + std::pow(larger.rms_m / std::max(smaller.rms_m, kMinRms_m), kIndependentPoints));
}

}  // namespace touchdown::estimator::pad
