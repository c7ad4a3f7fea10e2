#include "sim/render/floor_footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchdown::sim {

std::optional<FloorFootprint> FootprintOf(const PinholeView& view, const Eigen::Isometry3d& X_WC) {
  const double height = X_WC.translation().z();
  FloorFootprint footprint{.nearest_m = std::numeric_limits<double>::infinity()};
  for (const double u : {-0.5, view.width_px - 0.5}) {
    for (const double v : {-0.5, view.height_px - 0.5}) {
      const Eigen::Vector3d ray_C((u - view.cx_px) / view.focal_px, (v - view.cy_px) / view.focal_px, 1.0);
      const Eigen::Vector3d ray_W = X_WC.linear() * ray_C;
      const double depth = -height / ray_W.z();
      if (!(height > 0.0 && ray_W.z() < 0.0)) return std::nullopt;
      const Eigen::Vector2d p_W = (X_WC.translation() + depth * ray_W).head<2>();
      footprint.reach_m = std::max(footprint.reach_m, p_W.cwiseAbs().maxCoeff());
      footprint.nearest_m = std::min(footprint.nearest_m, depth);
      footprint.farthest_m = std::max(footprint.farthest_m, depth);
    }
  }
  return footprint;
}

}  // namespace touchdown::sim
