#pragma once

#include <Eigen/Geometry>

#include "models/angles.h"
#include "models/random_stream.h"

namespace touchdown::tests {

/// Random pose near the origin, with any orientation.
inline Eigen::Isometry3d RandomPose(models::RandomStream& random) {
  Eigen::Isometry3d X(Eigen::Translation3d(random.NormalVector3()));
  X.linear() = models::RotationExp(2.0 * random.NormalVector3());
  return X;
}

}  // namespace touchdown::tests
