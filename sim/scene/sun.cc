#include "sim/scene/sun.h"

#include <cmath>

#include "models/error.h"

namespace touchdown::sim {

void Sun::Validate() const {
  if (!(elevation >= models::DegToRad(10.0) && elevation <= models::DegToRad(90.0))) {
    throw InputError("scene: the sun's elevation must be between 10 and 90 degrees");
  }
  if (!std::isfinite(azimuth)) throw InputError("scene: the sun's azimuth must be finite");
  if (!(to_sky >= 0.0 && to_sky <= 20.0)) throw InputError("scene: the sun's to_sky must be between 0 and 20");
}

Eigen::Vector3d Sun::Direction() const {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace touchdown::sim
