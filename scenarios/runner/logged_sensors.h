#pragma once

#include <Eigen/Geometry>
#include <tuple>
#include <vector>

#include "sim/sensors/range_finder.h"
#include "sim/sensors/tracking_system.h"

namespace touchdown::runner {

/// A reading of a sensor, with the pose of the body at its tick.
template <typename Sensor>
struct SensorRecord {
  typename Sensor::Reading reading = {};
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< True pose.
};

/// Types of a list of sensors.
template <typename... Sensor>
struct SensorList {
  using Configs = std::tuple<typename Sensor::Config...>;
  using Sensors = std::tuple<Sensor...>;
  using Records = std::tuple<std::vector<SensorRecord<Sensor>>...>;
};

/// Sensors whose readings are logged and are not inputs of an estimator. A scenario configures each in the section
/// kName, and a flight writes its readings to kName.csv. A new one is a file in sim/sensors with a class of this form,
/// and its name here:
///
///     using Config;                                    // With Describe() and Validate(time).
///     using Reading;                                   // Signal with a `tick`.
///     static constexpr const char *kName, *kDoc;       // Name of section and table, and meaning of the section.
///     static constexpr const char* kColumns;           // Columns of the table, separated by commas.
///     static std::array<double, N> Columns(const Reading& reading);
///     Sensor(const Config& config, const models::TimeBase& time, std::uint64_t seed);  // Or (config, world, time,
///     seed). std::optional<Reading> Sample(const TrueState& truth);  // Called once per tick, in order.
using LoggedSensors = SensorList<sim::TrackingSystem, sim::RangeFinder>;

}  // namespace touchdown::runner
