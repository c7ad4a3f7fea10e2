#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <span>

namespace touchdown::estimator::calibration {

/// The mean of several measurements of one pose X_AB, and how far they scatter.
struct PoseMean {
  Eigen::Isometry3d X_AB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d position_scatter_m = Eigen::Vector3d::Zero();    ///< 1-sigma of one measurement, along A's axes.
  Eigen::Vector3d rotation_scatter_rad = Eigen::Vector3d::Zero();  ///< The same, as a rotation vector in A.
  std::size_t used = 0;                                            ///< Measurements that are no outliers.

  /// 1-sigma of the mean, for measurements that are independent of each other.
  Eigen::Vector3d position_sigma_m() const;
  Eigen::Vector3d rotation_sigma_rad() const;
};

/// The mean of positions, and of rotations the one at the least sum of squared chordal distances (Moakher 2002): the
/// rotation nearest to the sum of the matrices, by its singular value decomposition.
///
/// Outliers, as a tracking system gives them while a marker is hidden, are left out: positions and rotations over six
/// times the typical distance (1.48 median absolute deviations) from the median. Rotations are expected within some
/// tens of degrees of each other. Throws InputError when there is none, or a number is not finite.
PoseMean MeanPose(std::span<const Eigen::Isometry3d> measurements);

}  // namespace touchdown::estimator::calibration
