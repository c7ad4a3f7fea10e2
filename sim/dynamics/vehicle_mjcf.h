#pragma once

#include <string>

#include "models/vehicle.h"

namespace touchdown::sim {

inline constexpr char kVehicleBodyName[] = "vehicle";
inline constexpr char kOnboardCameraName[] = "onboard";

/// "foot_0" (front left), "foot_1" (front right), "foot_2" (rear right), "foot_3" (rear left): as the rotors.
std::string FootName(int foot);

/// The `<body>` element of a valid vehicle, for a scene's `<worldbody>`: frame B with a free joint, mass and inertia as
/// given, spheres for feet, legs, hull, arms and rotor discs that collide with the scene, and the camera `onboard` at
/// X_BC (MuJoCo's camera looks along its -Z, with Y up). Lengths that models::Vehicle does not know scale with the arm.
std::string VehicleMjcf(const models::Vehicle& vehicle);

}  // namespace touchdown::sim
