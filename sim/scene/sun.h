#pragma once

#include <Eigen/Core>

#include "models/describe.h"

namespace touchdown::sim {

/// The sun above an outdoor scene. Directions are in W, which is tilted with the ground.
struct Sun {
  double elevation_deg = 45.0;
  double azimuth_deg = 60.0;
  double to_sky = 0.5;

  /// Throws InputError, without a file name, for a value out of its range (see Describe).
  void Validate() const;

  /// Unit vector in W towards the sun.
  Eigen::Vector3d Direction() const;

  /// Light in the shadow divided by light in the sun.
  double Shade() const { return 1.0 / (1.0 + to_sky); }
};

void Describe(models::ConfigVisitor& v, Sun& sun);

}  // namespace touchdown::sim
