#include "sim/scene/sun.h"

#include <cmath>

#include "models/angles.h"

namespace touchdown::sim {

void Describe(models::ConfigVisitor& v, Sun& c) {
  using namespace models;
  v.Number({"elevation_deg", "Elevation of the sun above the ground plane. Lower casts longer shadows."},
           c.elevation_deg, kDegree, Between(10.0, 90.0));
  v.Number({"azimuth_deg", "Direction of the sun, from W's X towards Y."}, c.azimuth_deg, kDegree,
           Between(-360.0, 360.0));
  v.Number(
      {"to_sky",
       "Light of the sun on the ground over the light of the sky. Larger darkens the shadows: 0 is overcast without "
       "shadows, thin cloud is about 0.5, a clear sky 4."},
      c.to_sky, kNoUnit, Between(0.0, 20.0));
}

void Sun::Validate() const { models::ValidateConfig(*this); }

Eigen::Vector3d Sun::Direction() const {
  const double elevation = models::DegToRad(elevation_deg), azimuth = models::DegToRad(azimuth_deg);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace touchdown::sim
