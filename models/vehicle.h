#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "models/angles.h"
#include "models/describe.h"

namespace touchdown::models {

inline constexpr int kRotorCount = 4;
inline constexpr double kGravity_m_s2 = 9.81;

/// One of four identical rotors. Thrust is thrust_coefficient * speed^2 along +Z_B. Drag torque about Z_B, opposite to
/// the spin, is torque_ratio times the thrust. The speed follows its command as a first-order lag.
struct Rotor {
  double thrust_coefficient_n_s2 = 1.29e-5;  // 2.94 N at 477 rad/s, a 10 inch propeller.
  double torque_ratio_m = 0.0165;
  double time_constant_s = 0.04;
  double max_speed_rad_s = 660.0;  // 5.6 N: 400 g of payload with a margin for control.
  double min_speed_rad_s = 100.0;
  double propeller_diameter_m = 0.254;

  double ThrustAt(double speed_rad_s) const { return thrust_coefficient_n_s2 * speed_rad_s * speed_rad_s; }
  /// Speed in rad/s for a thrust in N; 0 if the thrust is not positive.
  double SpeedFor(double thrust_n) const;
};

/// Pose of a sensor on the body: its position p_BS, and Tait-Bryan angles in B that rotate it from its nominal
/// orientation.
struct Mounting {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  TaitBryanDeg misalignment_deg;
};

/// Landing gear: four contact points at (+-half_spacing, +-half_spacing, -height) in B.
struct LandingGear {
  double half_spacing_m = 0.13;
  double height_m = 0.14;
  double foot_radius_m = 0.012;
};

/// A quadrotor in X configuration (Sec. III-A). Body frame B: X forward, Y left, Z up, origin at the center of gravity.
///
/// Rotors 0 to 3: front left, front right, rear right, rear left. Rotors 0 and 2 spin clockwise seen from above (about
/// -Z_B), so that their drag turns the body left (+Z_B); 1 and 3 spin the other way.
struct Vehicle {
  double mass_kg = 1.2;
  Eigen::Vector3d inertia_kg_m2{0.0125, 0.0125, 0.0220};
  double arm_m = 0.20;
  double rotor_height_m = 0.03;
  Rotor rotor;
  Eigen::Vector3d linear_drag_n_s_m{0.25, 0.25, 0.35};
  Eigen::Vector3d quadratic_drag_n_s2_m2{0.02, 0.02, 0.04};
  LandingGear gear;
  Mounting camera{.position_m = {0.0, 0.0, -0.05}, .misalignment_deg = {}};
  Mounting imu;

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the moments violate
  /// the triangle inequality, the idle speed is not below the highest, the rotors cannot lift the vehicle, or the
  /// camera is not above the landing gear contact points.
  void Validate() const;

  /// Position of a rotor's hub in B.
  Eigen::Vector3d RotorPosition(int index) const;
  /// +1 when the rotor's drag torque acts along +Z_B, -1 when along -Z_B.
  static double DragTorqueSign(int rotor) { return rotor % 2 == 0 ? 1.0 : -1.0; }

  double HoverThrustPerRotor() const { return mass_kg * kGravity_m_s2 / kRotorCount; }

  /// Pose of the camera frame C in B. Nominally it looks down, with the image's top towards body forward.
  Eigen::Isometry3d X_BC() const;
  /// Pose of the IMU frame U in B. Nominally its axes are those of B.
  Eigen::Isometry3d X_BU() const;
};

void Describe(ConfigVisitor& v, Rotor& rotor);
void Describe(ConfigVisitor& v, Mounting& mounting);
void Describe(ConfigVisitor& v, LandingGear& gear);
void Describe(ConfigVisitor& v, Vehicle& vehicle);

/// Inverse of Vehicle::X_BC: the mounting that gives `X_BC`.
Mounting CameraMountingOf(const Eigen::Isometry3d& X_BC);
/// Inverse of Vehicle::X_BU: the mounting that gives `X_BU`.
Mounting ImuMountingOf(const Eigen::Isometry3d& X_BU);

}  // namespace touchdown::models
