#pragma once

#include <Eigen/Geometry>

namespace touchdown::models {

/// Interpolates between two poses of the same body in the same frame; `fraction` is 0 at `from` and 1 at `to`. The
/// position moves on a straight line. The rotation is about one axis at a constant rate, by at most 180 degrees.
inline Eigen::Isometry3d InterpolatePose(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double fraction) {
  const Eigen::Quaterniond q_from(from.linear()), q_to(to.linear());
  Eigen::Isometry3d X(q_from.slerp(fraction, q_to));
  X.translation() = (1.0 - fraction) * from.translation() + fraction * to.translation();
  return X;
}

}  // namespace touchdown::models
