#pragma once

namespace touchdown::sim {

/// MuJoCo's geom groups, by visibility to the camera.
enum GeomGroup : int {
  kScenery = 0,       ///< Visible: the pad, the floor around it, and the items on the floor.
  kSurroundings = 1,  ///< Drawn only in views beyond the center of the floor: the rest of the floor, the walls.
  kVehicle = 2,       ///< Not visible.
  kInvisible = 3,     ///< Solid, but not visible.
};

}  // namespace touchdown::sim
