#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "sim/render/pinhole_view.h"

namespace touchdown::sim {

/// Part of the floor's plane, z = 0 in W, that is in a view.
struct FloorFootprint {
  double reach_m = 0.0;     ///< Farthest from the origin along W's X or Y.
  double nearest_m = 0.0;   ///< Least depth along the optical axis.
  double farthest_m = 0.0;  ///< Greatest depth along the optical axis.
};

/// From the rays through the view's corners, of the camera at X_WC (Z along the optical axis). nullopt when one of them
/// misses the floor.
std::optional<FloorFootprint> FootprintOf(const PinholeView& view, const Eigen::Isometry3d& X_WC);

}  // namespace touchdown::sim
