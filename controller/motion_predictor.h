#pragma once

#include <Eigen/Core>

#include "models/angles.h"
#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Carries position and velocity on while the pad is not in view, from what is commanded: thrust along the body's Z,
/// gravity, and the disturbance that the position loop's trim stands against. Good for a second or two.
class MotionPredictor {
 public:
  /// `thrust_n` is the thrust that the rotors have at the start.
  MotionPredictor(const models::Vehicle& vehicle, double period_s, double thrust_n);

  /// Starts over from there.
  void Set(const models::VehicleEstimate::Motion& motion) { motion_ = motion; }

  /// Takes one period's step. `thrust_n` is the thrust commanded over it, `trim_m_s2` the acceleration in W that
  /// balances the constant disturbances.
  void Step(const models::TaitBryan& attitude, double thrust_n, const Eigen::Vector3d& trim_m_s2);

  /// Keeps a vehicle whose body is at `height_m` when it stands from sinking through the ground, or sliding on it.
  void StandAt(double height_m);

  const models::VehicleEstimate::Motion& motion() const { return motion_; }

 private:
  double mass_kg_;
  double period_s_;
  double lag_;  ///< Share of a thrust change that a period lets through.
  double thrust_n_;
  models::VehicleEstimate::Motion motion_;
};

}  // namespace touchdown::controller
