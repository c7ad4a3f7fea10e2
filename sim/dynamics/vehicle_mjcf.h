#pragma once

#include <string>

#include "models/vehicle.h"

namespace touchdown::sim {

inline constexpr char kVehicleBodyName[] = "vehicle";
inline constexpr char kOnboardCameraName[] = "onboard";

/// Name of the geom of a landing gear contact point, in the order of the rotors: "foot_0" (front left), "foot_1" (front
/// right), "foot_2" (rear right), "foot_3" (rear left).
std::string FootName(int foot);

/// The `<body>` element of a valid vehicle, for a scene's `<worldbody>`: frame B with a free joint, the mass and
/// inertia of the vehicle, spheres as feet, legs, hull, arms and rotor discs that collide with the scene, and the
/// camera `onboard` at X_BC (MuJoCo's camera looks along its -Z, with Y up). Lengths that models::Vehicle does not
/// define are proportional to arm_m.
std::string VehicleMjcf(const models::Vehicle& vehicle);

}  // namespace touchdown::sim
