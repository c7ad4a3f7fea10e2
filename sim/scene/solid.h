#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/scene/scene.h"

namespace touchdown::sim {

/// A convex solid: a box, cylinder, capsule, sphere or ellipsoid, with its size in MuJoCo's convention.
struct Solid {
  mjtGeom type = mjGEOM_BOX;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  Eigen::Isometry3d X_WG = Eigen::Isometry3d::Identity();
};

/// Shape and pose of a solid item. Throws std::logic_error for a flat item.
Solid SolidOf(const SceneItem& item);

}  // namespace touchdown::sim
