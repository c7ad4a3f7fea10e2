#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "sim/render/pinhole_view.h"

namespace touchdown::sim {

/// Part of the floor plane, z = 0 in W, that is visible in a view.
struct FloorFootprint {
  double reach_m = 0.0;     ///< Largest distance from the origin along W's X or Y.
  double nearest_m = 0.0;   ///< Least depth along the optical axis.
  double farthest_m = 0.0;  ///< Greatest depth along the optical axis.
};

/// Computes the footprint from the rays through the view's corners, for the camera at X_WC (Z along the optical axis).
/// Returns nullopt when one of the rays misses the floor.
std::optional<FloorFootprint> FootprintOf(const PinholeView& view, const Eigen::Isometry3d& X_WC);

}  // namespace touchdown::sim
