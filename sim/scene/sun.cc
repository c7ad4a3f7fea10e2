#include "sim/scene/sun.h"

#include <cmath>

#include "models/angles.h"

namespace touchdown::sim {

void Describe(models::ConfigVisitor& v, Sun& c) {
  using namespace models;
  v.Number({"elevation_deg", "Elevation of the sun above the ground plane. A smaller value casts longer shadows."},
           c.elevation_deg, kDegree, Between(10.0, 90.0));
  v.Number({"azimuth_deg", "Direction of the sun, from W's X towards Y."}, c.azimuth_deg, kDegree,
           Between(-360.0, 360.0));
  v.Number({"to_sky",
            "Ratio of sunlight to skylight on the ground. A larger value darkens the shadows: 0 is overcast without "
            "shadows, thin cloud is about 0.5, a clear sky is 4."},
           c.to_sky, kNoUnit, Between(0.0, 20.0));
}

void Sun::Validate() const { models::ValidateConfig(*this); }

Eigen::Vector3d Sun::Direction() const {
  const double elevation = models::DegToRad(elevation_deg), azimuth = models::DegToRad(azimuth_deg);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace touchdown::sim
