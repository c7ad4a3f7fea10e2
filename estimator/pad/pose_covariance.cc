#include "estimator/pad/pose_covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::pad {
namespace {

using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Smallest fraction to which the step to a sigma point is reduced.
constexpr double kMinFraction = 1.0 / 64.0;

/// Derivative of DistanceFrom(ellipse, point) with respect to the ellipse's parameters. With W = S^-1 and d = point -
/// center, the distance is (d^T W d - 1) / (2 |W d|), and dW = -W dS W.
EllipseParameters DistanceGradient(const Eigen::Matrix2d& W, const Eigen::Vector2d& from_center) {
  const Eigen::Vector2d Wd = W * from_center;
  EllipseParameters gradient;
  gradient << -2.0 * Wd, -Wd.x() * Wd.x(), -2.0 * Wd.x() * Wd.y(), -Wd.y() * Wd.y();
  return gradient / (2.0 * Wd.norm());
}

Vector6d Difference(const Eigen::Isometry3d& X_WB, const Eigen::Isometry3d& reference) {
  Vector6d difference;
  difference << X_WB.translation() - reference.translation(),
      models::RotationLog(X_WB.linear() * reference.linear().transpose());
  return difference;
}

}  // namespace

void PoseCovarianceConfig::Validate() const {
  for (const double value : {min_edge_sigma_px, points_per_independent_point, letter_sigma_rad, gravity_sigma_rad,
                             added_position_sigma_m, added_angle_sigma_rad}) {
    if (!std::isfinite(value) || value <= 0.0) {
      throw InputError("the settings of the pose covariance must be positive and finite");
    }
  }
}

EllipseParameters ParametersOf(const Ellipse& ellipse) {
  const Eigen::Matrix2d S = ellipse.Shape();
  EllipseParameters parameters;
  parameters << ellipse.center, S(0, 0), S(0, 1), S(1, 1);
  return parameters;
}

std::optional<Ellipse> EllipseOf(const EllipseParameters& parameters) {
  Eigen::Matrix2d S;
  S << parameters(2), parameters(3), parameters(3), parameters(4);
  return Ellipse::FromShape(parameters.head<2>(), S);
}

std::optional<Matrix5d> EllipseCovariance(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points,
                                          const PoseCovarianceConfig& config) {
  constexpr std::size_t kParameters = 5;
  if (points.size() <= kParameters) return std::nullopt;
  // Lengths are scaled by the size of the ellipse, so that the information matrix is well conditioned.
  const double size = ellipse.semi_axes.x();
  const Eigen::Matrix2d W = (ellipse.Shape() / (size * size)).inverse();
  Matrix5d information = Matrix5d::Zero();
  double squares = 0.0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d from_center = (point - ellipse.center) / size;
    const EllipseParameters gradient = DistanceGradient(W, from_center);
    if (!gradient.allFinite()) continue;
    information += gradient * gradient.transpose();
    const double distance = DistanceFrom(ellipse, point);
    squares += distance * distance;
  }
  const double variance = std::max(squares / static_cast<double>(points.size() - kParameters),
                                   config.min_edge_sigma_px * config.min_edge_sigma_px);
  const Eigen::LDLT<Matrix5d> factors(information);
  if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 1e-12 * factors.vectorD().maxCoeff()) {
    return std::nullopt;
  }
  const double scaled = variance / (size * size) * config.points_per_independent_point;
  EllipseParameters units;
  units << size, size, size * size, size * size, size * size;
  return Matrix5d(units.asDiagonal() * (scaled * factors.solve(Matrix5d::Identity())) * units.asDiagonal());
}

double StrokeSigma(const Ellipse& letter, std::size_t point_count, double edge_sigma_px, double not_rectified,
                   const PoseCovarianceConfig& config) {
  // Errors of points along a line of half length a rotate the line with an effective arm of a / sqrt(3). For an ellipse
  // the arm shrinks to 0 as the ellipse becomes a circle.
  const double elongation = letter.semi_axes.x() / letter.semi_axes.y();
  const double arm_px = letter.semi_axes.x() / std::sqrt(3.0) * (1.0 - 1.0 / (elongation * elongation));
  const double independent_points = static_cast<double>(point_count) / config.points_per_independent_point;
  const double edge_part = edge_sigma_px / (std::max(arm_px, 0.1) * std::sqrt(std::max(independent_points, 1.0)));
  return std::hypot(edge_part, config.letter_sigma_rad, not_rectified);
}

std::optional<Matrix6d> PoseCovariance(
    const Ellipse& ring, const Matrix5d& ring_covariance, double stroke_angle, double stroke_sigma,
    const Eigen::Isometry3d& X_WB,
    const std::function<std::optional<Eigen::Isometry3d>(const Ellipse& ring, double stroke_angle)>& pose_of,
    const PoseCovarianceConfig& config) {
  constexpr int kInputs = 6;
  const double spread = std::sqrt(static_cast<double>(kInputs));
  const Eigen::LLT<Matrix5d> root(ring_covariance);
  const Matrix5d L = root.matrixL();
  const EllipseParameters mean = ParametersOf(ring);
  // Change of the pose for the step to a sigma point.
  const auto effect_of = [&](const EllipseParameters& ring_step, double stroke_step) -> std::optional<Vector6d> {
    for (double fraction = 1.0; fraction >= kMinFraction; fraction /= 2.0) {
      const auto ellipse = EllipseOf(mean + fraction * ring_step);
      const auto pose = ellipse ? pose_of(*ellipse, stroke_angle + fraction * stroke_step) : std::nullopt;
      if (pose) return Difference(*pose, X_WB) / fraction;
    }
    return std::nullopt;
  };

  Matrix6d covariance = Matrix6d::Zero();
  for (const double side : {-spread, spread}) {
    for (int i = 0; i < kInputs; ++i) {
      const auto effect =
          i < 5 ? effect_of(side * L.col(i), 0.0) : effect_of(EllipseParameters::Zero(), side * stroke_sigma);
      if (!effect) return std::nullopt;
      covariance += *effect * effect->transpose() / (2.0 * kInputs);
    }
  }
  const double position = config.added_position_sigma_m, angle = config.added_angle_sigma_rad;
  covariance.diagonal().head<3>().array() += position * position;
  covariance.diagonal().tail<3>().array() += angle * angle;
  return covariance;
}

Matrix6d WrongBranchCovariance(const Eigen::Isometry3d& X_WB, const Eigen::Isometry3d& other_X_WB, double probability) {
  const Vector6d difference = Difference(other_X_WB, X_WB);
  return probability * difference * difference.transpose();
}

}  // namespace touchdown::estimator::pad
