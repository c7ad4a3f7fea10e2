#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/scene/solid.h"

namespace touchdown::sim {

/// The corners, in order, of the shadow on the ground (z = 0 of W) of a solid above it. `to_light` points in W towards
/// a light infinitely far away, above the ground. Curves are polygons of 24 corners. Throws std::logic_error for
/// another type of solid.
std::vector<Eigen::Vector2d> ShadowOutline(const Solid& solid, const Eigen::Vector3d& to_light);

}  // namespace touchdown::sim
