#pragma once

#include <Eigen/Geometry>

namespace touchdown::models {

/// The pose a fraction, 0 to 1, of the way from one pose to another, both of the same body in the same frame: the
/// position moves along a straight line, the rotation turns about one axis at a constant rate, the shorter way.
inline Eigen::Isometry3d InterpolatePose(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double fraction) {
  const Eigen::Quaterniond q_from(from.linear()), q_to(to.linear());
  Eigen::Isometry3d X(q_from.slerp(fraction, q_to));
  X.translation() = (1.0 - fraction) * from.translation() + fraction * to.translation();
  return X;
}

}  // namespace touchdown::models
