#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <span>

namespace touchdown::estimator::calibration {

/// Mean and scatter of several measurements of one pose X_AB.
struct PoseMean {
  Eigen::Isometry3d X_AB = Eigen::Isometry3d::Identity();
  /// Standard deviation of one measurement, along the axes of A.
  Eigen::Vector3d position_scatter_m = Eigen::Vector3d::Zero();
  /// Standard deviation of one measurement, as a rotation vector in A.
  Eigen::Vector3d rotation_scatter_rad = Eigen::Vector3d::Zero();
  std::size_t used = 0;  ///< Number of measurements used, without outliers.

  /// Standard deviation of the mean for independent measurements.
  Eigen::Vector3d position_sigma_m() const;
  Eigen::Vector3d rotation_sigma_rad() const;
};

/// Mean of the measurements without outliers.
///
/// The position is the arithmetic mean. The rotation minimizes the sum of squared chordal distances (Moakher 2002): it
/// is the rotation nearest to the sum of the matrices, computed by singular value decomposition.
///
/// Outliers, as a tracking system produces them while a marker is hidden, are positions or rotations more than six
/// robust standard deviations (1.48 times the median absolute deviation) from the median on an axis. The rotations are
/// expected to be within some tens of degrees of each other. Throws InputError for no measurements or for a value that
/// is not finite.
PoseMean MeanPose(std::span<const Eigen::Isometry3d> measurements);

}  // namespace touchdown::estimator::calibration
