#include "estimator/calibration/pose_mean.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/order_statistic.h"

namespace touchdown::estimator::calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d Median(const std::vector<Vector3d>& points) {
  Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vector3d& point : points) values.push_back(point[axis]);
    median[axis] = models::UpperMedian(values);
  }
  return median;
}

/// For each point, whether it is within the outlier limit of the median on every axis.
std::vector<bool> NearMedian(const std::vector<Vector3d>& points) {
  constexpr double kSigmaPerMedianDeviation = 1.4826, kMostSigmas = 6.0, kRounding = 1e-12;
  const Vector3d median = Median(points);
  std::vector<Vector3d> deviations;
  for (const Vector3d& point : points) deviations.push_back((point - median).cwiseAbs());
  const Vector3d limit =
      (kMostSigmas * kSigmaPerMedianDeviation * Median(deviations)).array() + kRounding * (1.0 + median.norm());
  std::vector<bool> near;
  for (const Vector3d& deviation : deviations) near.push_back((deviation.array() <= limit.array()).all());
  return near;
}

std::vector<Isometry3d> WithoutOutliers(std::span<const Isometry3d> measurements) {
  std::vector<Vector3d> positions, rotations;
  const Matrix3d R_first = measurements.front().linear();
  for (const Isometry3d& X : measurements) {
    positions.push_back(X.translation());
    rotations.push_back(models::RotationLog(X.linear() * R_first.transpose()));
  }
  const std::vector<bool> position_near = NearMedian(positions), rotation_near = NearMedian(rotations);
  std::vector<Isometry3d> kept;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (position_near[i] && rotation_near[i]) kept.push_back(measurements[i]);
  }
  // With very few measurements, every one may be an outlier of position or of rotation.
  return kept.empty() ? std::vector<Isometry3d>(measurements.begin(), measurements.end()) : kept;
}

Matrix3d NearestRotation(const Matrix3d& M) {
  const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
}

Isometry3d Mean(const std::vector<Isometry3d>& poses) {
  Vector3d position = Vector3d::Zero();
  Matrix3d sum = Matrix3d::Zero();
  for (const Isometry3d& X : poses) {
    position += X.translation() / static_cast<double>(poses.size());
    sum += X.linear();
  }
  Isometry3d mean = Isometry3d::Identity();
  mean.linear() = NearestRotation(sum);
  mean.translation() = position;
  return mean;
}

}  // namespace

Vector3d PoseMean::position_sigma_m() const { return position_scatter_m / std::sqrt(static_cast<double>(used)); }
Vector3d PoseMean::rotation_sigma_rad() const { return rotation_scatter_rad / std::sqrt(static_cast<double>(used)); }

PoseMean MeanPose(std::span<const Isometry3d> measurements) {
  if (measurements.empty()) throw InputError("the mean of poses needs at least one pose");
  for (const Isometry3d& X : measurements) {
    if (!X.matrix().allFinite()) throw InputError("a pose to average has a value that is not finite");
  }
  const std::vector<Isometry3d> kept = WithoutOutliers(measurements);
  PoseMean mean{.X_AB = Mean(kept), .used = kept.size()};
  if (kept.size() < 2) return mean;
  Vector3d position_variance = Vector3d::Zero(), rotation_variance = Vector3d::Zero();
  for (const Isometry3d& X : kept) {
    position_variance += (X.translation() - mean.X_AB.translation()).cwiseAbs2();
    rotation_variance += models::RotationLog(X.linear() * mean.X_AB.linear().transpose()).cwiseAbs2();
  }
  const auto degrees_of_freedom = static_cast<double>(kept.size() - 1);
  mean.position_scatter_m = (position_variance / degrees_of_freedom).cwiseSqrt();
  mean.rotation_scatter_rad = (rotation_variance / degrees_of_freedom).cwiseSqrt();
  return mean;
}

}  // namespace touchdown::estimator::calibration
