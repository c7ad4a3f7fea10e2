#include "models/vehicle.h"

#include <cmath>
#include <numbers>

#include "models/error.h"

namespace touchdown::models {
namespace {

Eigen::Isometry3d Pose(const Mounting& mounting, const Eigen::Matrix3d& R_BS_nominal) {
  Eigen::Isometry3d X_BS = Eigen::Isometry3d::Identity();
  X_BS.linear() = RotationFromTaitBryan(ToRadians(mounting.misalignment_deg)) * R_BS_nominal;
  X_BS.translation() = mounting.position_m;
  return X_BS;
}

/// R_BC of a camera that looks down, with the image's top towards body forward.
Eigen::Matrix3d R_LookingDown() {
  Eigen::Matrix3d R;
  R << 0, -1, 0,  //
      -1, 0, 0,   //
      0, 0, -1;
  return R;
}

void RequireAirworthy(const Vehicle& vehicle) {
  const Rotor& rotor = vehicle.rotor;
  if (2.0 * vehicle.inertia_kg_m2.maxCoeff() > vehicle.inertia_kg_m2.sum()) {
    throw InputError("the vehicle's moments of inertia violate the triangle inequality");
  }
  if (rotor.min_speed_rad_s >= rotor.max_speed_rad_s) {
    throw InputError("the rotor's min_speed_rad_s must be less than its max_speed_rad_s");
  }
  if (rotor.ThrustAt(rotor.max_speed_rad_s) <= vehicle.HoverThrustPerRotor()) {
    throw InputError("the vehicle's rotors cannot lift its mass");
  }
  if (vehicle.camera.position_m.z() <= -vehicle.gear.height_m) {
    throw InputError("the vehicle's camera must be above the landing gear contact points");
  }
}

}  // namespace

double Rotor::SpeedFor(double thrust_n) const {
  return thrust_n > 0.0 ? std::sqrt(thrust_n / thrust_coefficient_n_s2) : 0.0;
}

void Describe(ConfigVisitor& v, Rotor& r) {
  v.Number({"thrust_coefficient_n_s2", "Thrust divided by the squared rotor speed in rad/s."},
           r.thrust_coefficient_n_s2, {"N s^2"}, kPositive);
  v.Number({"torque_ratio_m", "Drag torque divided by thrust."}, r.torque_ratio_m, kMeter, kPositive);
  v.Number({"time_constant_s",
            "Time constant of the lag from commanded to actual speed. A larger value delays every correction."},
           r.time_constant_s, kSecond, kPositiveTime);
  v.Number({"max_speed_rad_s", "Highest rotor speed. It limits the thrust, and with it the payload."},
           r.max_speed_rad_s, kRadianPerSecond, kPositive);
  v.Number({"min_speed_rad_s", "Idle speed of a running motor. A command of 0 stops it."}, r.min_speed_rad_s,
           kRadianPerSecond, kNotNegative);
  v.Number({"propeller_diameter_m", "Diameter of the propeller."}, r.propeller_diameter_m, kMeter, kPositive);
}

void Describe(ConfigVisitor& v, Mounting& m) {
  v.Vector3({"position_m", "Position of the sensor in the body frame."}, m.position_m, kMeter, Between(-2.0, 2.0));
  v.Numbers({"misalignment_deg",
             "Roll, pitch and yaw that rotate the sensor from its nominal orientation, in the body frame."},
            {&m.misalignment_deg.roll, &m.misalignment_deg.pitch, &m.misalignment_deg.yaw}, kDegree,
            Between(-180.0, 180.0));
}

void Describe(ConfigVisitor& v, LandingGear& g) {
  v.Number({"half_spacing_m", "Half of the distance between two contact points, along X and Y."}, g.half_spacing_m,
           kMeter, kPositive);
  v.Number({"height_m", "Height of the body's origin above the landing gear contact points."}, g.height_m, kMeter,
           kPositive);
  v.Number({"foot_radius_m", "Radius of the sphere at each contact point."}, g.foot_radius_m, kMeter, kPositive);
}

void Describe(ConfigVisitor& v, Vehicle& c) {
  v.Number({"mass_kg", "Mass with battery and payload."}, c.mass_kg, kKilogram, kPositive);
  v.Vector3({"inertia_kg_m2", "Principal moments of inertia along the body's axes."}, c.inertia_kg_m2, {"kg m^2"},
            kPositive);
  v.Number({"arm_m", "Horizontal distance from the body's origin to each rotor."}, c.arm_m, kMeter, kPositive);
  v.Number({"rotor_height_m", "Height of the rotor plane above the body's origin."}, c.rotor_height_m, kMeter,
           Between(-2.0, 2.0));
  v.Keys({"rotor", "Motor and propeller; all four are identical."}, c.rotor);
  v.Vector3({"linear_drag_n_s_m", "Drag force divided by airspeed along the body's axes (rotor drag)."},
            c.linear_drag_n_s_m, {"N s/m"}, kNotNegative);
  v.Vector3({"quadratic_drag_n_s2_m2", "Drag force divided by squared airspeed along the body's axes (fuselage)."},
            c.quadratic_drag_n_s2_m2, {"N s^2/m^2"}, kNotNegative);
  v.Keys({"gear", "Landing gear with four contact points."}, c.gear);
  v.Keys({"camera", "Mounting of the camera. Nominally it looks down, with the image's top towards body forward."},
         c.camera);
  v.Keys({"imu", "Mounting of the IMU. Nominally its axes are those of the body."}, c.imu);
  v.Check("", [&c] { RequireAirworthy(c); });
}

void Vehicle::Validate() const { ValidateConfig(*this); }

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
          .misalignment_deg = ToDegrees(TaitBryanFromRotation(X_BC.linear() * R_LookingDown().transpose()))};
}

Mounting ImuMountingOf(const Eigen::Isometry3d& X_BU) {
  return {.position_m = X_BU.translation(), .misalignment_deg = ToDegrees(TaitBryanFromRotation(X_BU.linear()))};
}

}  // namespace touchdown::models
