#pragma once

#include <Eigen/Core>

#include "models/angles.h"

namespace touchdown::sim {

/// The sun over the ground outdoors. Places and angles are of W, so that on tilted ground they are the ground's.
struct Sun {
  double elevation = models::DegToRad(45.0);  ///< Over the ground's plane.
  double azimuth = models::DegToRad(60.0);    ///< Where it stands, from X towards Y.
  /// Its light on the ground over the sky's: 0 is overcast and without shadows, thin cloud leaves some 0.5, a clear
  /// sky 4.
  double to_sky = 0.5;

  /// Throws InputError, without a file name, for an elevation outside [10, 90] degrees, a ratio outside [0, 20] or an
  /// azimuth that is not finite.
  void Validate() const;

  /// Unit vector in W towards it.
  Eigen::Vector3d Direction() const;

  /// What the ground keeps of its light where the sun does not reach.
  double Shade() const { return 1.0 / (1.0 + to_sky); }
};

}  // namespace touchdown::sim
