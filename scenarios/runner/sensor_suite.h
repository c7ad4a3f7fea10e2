#pragma once

#include <cstdint>
#include <utility>

#include "models/time.h"
#include "scenarios/runner/logged_sensors.h"
#include "sim/dynamics/world.h"

namespace touchdown::runner {

/// Samples and records the logged sensors of a flight.
class SensorSuite {
 public:
  /// `world` must outlive the suite. Throws InputError for an invalid config.
  SensorSuite(const LoggedSensors::Configs& configs, const sim::World& world, const models::TimeBase& time,
              std::uint64_t seed);

  /// Samples the sensors. Call once per tick, in order.
  void Sample(const sim::TrueState& truth);

  /// Moves the records out of the suite.
  LoggedSensors::Records TakeRecords() { return std::move(records_); }

 private:
  LoggedSensors::Sensors sensors_;
  LoggedSensors::Records records_;
};

}  // namespace touchdown::runner
