#pragma once

namespace touchdown::sim {

/// MuJoCo's geom groups, by what the camera has to do with them.
enum GeomGroup : int {
  kScenery = 0,       ///< Seen: the pad, the floor about it, and all that lies on the floor.
  kSurroundings = 1,  ///< Seen beyond the floor's center only: the rest of the floor, the walls.
  kVehicle = 2,       ///< Not seen.
  kInvisible = 3,     ///< Solid, but not seen.
};

}  // namespace touchdown::sim
