#include "sim/dynamics/ground_tilt.h"

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::sim {
namespace {

constexpr double kSteepest = models::DegToRad(15.0);

}  // namespace

void GroundTilt::Validate() const {
  if (!(std::cos(roll) * std::cos(pitch) >= std::cos(kSteepest))) {
    throw InputError("the ground must not be steeper than 15 degrees");
  }
}

Eigen::Vector3d GroundTilt::Gravity() const {
  const Eigen::Matrix3d R_LW = models::RotationFromTaitBryan({.roll = roll, .pitch = pitch, .yaw = 0.0});
  return R_LW.transpose() * Eigen::Vector3d(0.0, 0.0, -models::kGravity_m_s2);
}

}  // namespace touchdown::sim
