#pragma once

#include "models/signals.h"
#include "models/time.h"
#include "models/vehicle.h"

namespace touchdown::tests {

inline constexpr models::TimeBase kTime;
inline const models::Vehicle kVehicle;
inline const double kWeight_n = kVehicle.mass_kg * models::kGravity_m_s2;
inline constexpr double kPeriod_s = 0.005;  ///< Period of IMU and attitude loop.
inline constexpr double kG = models::kGravity_m_s2;

}  // namespace touchdown::tests
