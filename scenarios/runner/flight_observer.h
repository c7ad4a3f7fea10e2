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

  /// Before anything else, with the vehicle at its start.
  virtual void OnStart(const sim::World& /*world*/) {}

  /// A sample of the IMU as the estimator is given it, with whether the vehicle knew that it stood on the ground,
  /// motors off. Ticks below 0 belong to a vehicle that stood before a flight that begins in the air.
  virtual void OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) {}

  /// Called for a frame that is delivered at this tick, with its estimate and its record.
  virtual void OnFrame(const models::CameraFrame& /*frame*/, const estimator::FrameResult& /*estimate*/,
                       const FrameRecord& /*record*/) {}
};

}  // namespace touchdown::runner
