#include "sim/dynamics/ground_tilt.h"

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::sim {
namespace {

constexpr double kSteepest = models::DegToRad(15.0);

models::TaitBryan Angles(const GroundTilt& ground) {
  return {.roll = models::DegToRad(ground.roll_deg), .pitch = models::DegToRad(ground.pitch_deg), .yaw = 0.0};
}

}  // namespace

void GroundTilt::Validate() const {
  const auto [roll, pitch, yaw] = Angles(*this);
  if (!(std::cos(roll) * std::cos(pitch) >= std::cos(kSteepest))) {
    throw InputError("the ground must not be steeper than 15 degrees");
  }
}

Eigen::Vector3d GroundTilt::Gravity() const {
  const Eigen::Matrix3d R_LW = models::RotationFromTaitBryan(Angles(*this));
  return R_LW.transpose() * Eigen::Vector3d(0.0, 0.0, -models::kGravity_m_s2);
}

}  // namespace touchdown::sim
