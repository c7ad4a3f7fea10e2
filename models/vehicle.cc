#include "models/vehicle.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "models/error.h"

namespace touchdown::models {
namespace {

Eigen::Isometry3d Pose(const Mounting& mounting, const Eigen::Matrix3d& R_nominal) {
  Eigen::Isometry3d X_BS = Eigen::Isometry3d::Identity();
  X_BS.linear() = RotationFromTaitBryan(mounting.misalignment) * R_nominal;
  X_BS.translation() = mounting.position_m;
  return X_BS;
}

/// The camera looks down, the image's up towards body forward.
Eigen::Matrix3d R_LookingDown() {
  Eigen::Matrix3d R;
  R << 0, -1, 0,  //
      -1, 0, 0,   //
      0, 0, -1;
  return R;
}

bool IsFinite(const Mounting& mounting) {
  const auto& [roll, pitch, yaw] = mounting.misalignment;
  return mounting.position_m.allFinite() && std::isfinite(roll) && std::isfinite(pitch) && std::isfinite(yaw);
}

}  // namespace

double Rotor::SpeedFor(double thrust_n) const {
  return thrust_n > 0.0 ? std::sqrt(thrust_n / thrust_coefficient_n_s2) : 0.0;
}

void Vehicle::Validate() const {
  for (const double value :
       {mass_kg, inertia_kg_m2.x(), inertia_kg_m2.y(), inertia_kg_m2.z(), arm_m, rotor.thrust_coefficient_n_s2,
        rotor.torque_ratio_m, rotor.time_constant_s, rotor.max_speed_rad_s, rotor.propeller_diameter_m,
        gear.half_spacing_m, gear.height_m, gear.foot_radius_m}) {
    if (!std::isfinite(value) || value <= 0.0) {
      throw InputError("the vehicle's masses, lengths and coefficients must be positive and finite");
    }
  }
  if (!IsFinite(camera) || !IsFinite(imu) || !std::isfinite(rotor_height_m) || !linear_drag_n_s_m.allFinite() ||
      !quadratic_drag_n_s2_m2.allFinite() || !std::isfinite(rotor.min_speed_rad_s)) {
    throw InputError("the vehicle has a number that is not finite");
  }
  if (linear_drag_n_s_m.minCoeff() < 0.0 || quadratic_drag_n_s2_m2.minCoeff() < 0.0) {
    throw InputError("the vehicle's drag must not be negative");
  }
  if (2.0 * inertia_kg_m2.maxCoeff() > inertia_kg_m2.sum()) {
    throw InputError("the vehicle's moments of inertia break the triangle inequality");
  }
  if (rotor.min_speed_rad_s < 0.0 || rotor.min_speed_rad_s >= rotor.max_speed_rad_s) {
    throw InputError("the rotor's idle speed must lie between 0 and its highest speed");
  }
  if (rotor.ThrustAt(rotor.max_speed_rad_s) <= HoverThrustPerRotor()) {
    throw InputError("the vehicle's rotors cannot lift its mass");
  }
  if (camera.position_m.z() <= -gear.height_m) throw InputError("the vehicle's camera must sit above its feet");
}

Eigen::Vector3d Vehicle::RotorPosition(int index) const {
  const double offset = arm_m / std::numbers::sqrt2;
  const double forward = index == 0 || index == 1 ? offset : -offset;
  const double left = index == 0 || index == 3 ? offset : -offset;
  return {forward, left, rotor_height_m};
}

Eigen::Isometry3d Vehicle::X_BC() const { return Pose(camera, R_LookingDown()); }

Eigen::Isometry3d Vehicle::X_BU() const { return Pose(imu, Eigen::Matrix3d::Identity()); }

Mounting CameraMountingOf(const Eigen::Isometry3d& X_BC) {
  return {.position_m = X_BC.translation(),
          .misalignment = TaitBryanFromRotation(X_BC.linear() * R_LookingDown().transpose())};
}

Mounting ImuMountingOf(const Eigen::Isometry3d& X_BU) {
  return {.position_m = X_BU.translation(), .misalignment = TaitBryanFromRotation(X_BU.linear())};
}

}  // namespace touchdown::models
