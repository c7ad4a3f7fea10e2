#pragma once

#include "estimator/frame_result.h"
#include "models/signals.h"
#include "scenarios/runner/flight_log.h"
#include "sim/dynamics/world.h"

namespace touchdown::runner {

/// Observes a flight while it is flown, to draw it, to record it or to report progress. Nothing that it does reaches
/// the flight, unless it throws, which ends it.
class FlightObserver {
 public:
  virtual ~FlightObserver() = default;

  /// Called first, with the vehicle at its start.
  virtual void OnStart(const sim::World& /*world*/) {}

  /// Called for each IMU sample that the estimator gets. `at_rest`: the vehicle is on the ground with its motors off.
  /// Negative ticks precede a flight that starts in the air.
  virtual void OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) {}

  /// Called for a frame that is delivered at this tick, with its estimate and its record.
  virtual void OnFrame(const models::CameraFrame& /*frame*/, const estimator::FrameResult& /*estimate*/,
                       const FrameRecord& /*record*/) {}
};

}  // namespace touchdown::runner
