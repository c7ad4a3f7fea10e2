#pragma once

#include "estimator/frame_result.h"
#include "models/signals.h"
#include "scenarios/runner/flight_log.h"
#include "sim/dynamics/world.h"

namespace touchdown::runner {

/// Interface of observers of a running flight, which draw or record it or report progress. An observer cannot affect
/// the flight, except that an exception ends it.
class FlightObserver {
 public:
  virtual ~FlightObserver() = default;

  /// Called before the first tick, with the vehicle at its start.
  virtual void OnStart(const sim::World& /*world*/) {}

  /// Called for each IMU sample of the estimator. `at_rest` is true while the vehicle is on the ground with its motors
  /// off. Samples with negative ticks precede a flight that starts in the air.
  virtual void OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) {}

  /// Called for a frame that is delivered at this tick, with its estimate and its record.
  virtual void OnFrame(const models::CameraFrame& /*frame*/, const estimator::FrameResult& /*estimate*/,
                       const FrameRecord& /*record*/) {}
};

}  // namespace touchdown::runner
