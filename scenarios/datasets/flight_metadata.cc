#include "scenarios/datasets/flight_metadata.h"

namespace touchdown::datasets {

void SetFlightMetadata(const runner::Scenario& scenario, FootageMetadata& metadata) {
  metadata.frame_order = estimator::FrameOrder::kFlight;
  metadata.time = scenario.time;
  metadata.latency = scenario.time.FromSeconds(scenario.camera.latency_s());
  metadata.camera = scenario.assumed_camera();
  metadata.pad = scenario.pad;
  const models::Vehicle assumed = scenario.assumed_vehicle();
  metadata.mounting = {assumed.X_BC(), assumed.X_BU()};
  metadata.estimator = scenario.estimator;
}

}  // namespace touchdown::datasets
