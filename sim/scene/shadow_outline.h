#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/scene/solid.h"

namespace touchdown::sim {

/// Outline of the shadow of a solid on the ground (z = 0 of W): the corners in order, in W. `to_light` is a vector in W
/// towards a light infinitely far away, above the ground. Curves are polygons with 24 corners. Throws std::logic_error
/// for a type that Solid does not list.
std::vector<Eigen::Vector2d> ShadowOutline(const Solid& solid, const Eigen::Vector3d& to_light);

}  // namespace touchdown::sim
