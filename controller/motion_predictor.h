#pragma once

#include <Eigen/Core>

#include "models/angles.h"
#include "models/signals.h"
#include "models/vehicle.h"

namespace touchdown::controller {

/// Predicts position and velocity while the pad is not in view, from the commanded thrust along Z_B, gravity, and
/// the disturbance that the trim of the position loop balances. It is accurate for one or two seconds.
class MotionPredictor {
 public:
  /// `thrust_n` is the thrust that the rotors have at the start.
  MotionPredictor(const models::Vehicle& vehicle, double period_s, double thrust_n);

  /// Restarts from a state.
  void Set(const models::VehicleEstimate::Motion& motion) { motion_ = motion; }

  /// Predicts one period. `thrust_n` is the thrust commanded over it, `trim_m_s2` the acceleration in W that
  /// balances the constant disturbances.
  void Step(const models::TaitBryan& attitude, double thrust_n, const Eigen::Vector3d& trim_m_s2);

  /// Keeps the vehicle on the ground, without sliding, where its body would be below the standing height `height_m`.
  void StandAt(double height_m);

  const models::VehicleEstimate::Motion& motion() const { return motion_; }

 private:
  double mass_kg_;
  double period_s_;
  double lag_;  ///< Fraction of a thrust change that becomes effective in one period.
  double thrust_n_;
  models::VehicleEstimate::Motion motion_;
};

}  // namespace touchdown::controller
