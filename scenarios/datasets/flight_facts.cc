#include "scenarios/datasets/flight_facts.h"

namespace touchdown::datasets {

void DescribeFlight(const runner::Scenario& scenario, FootageFacts& facts) {
  facts.frame_order = estimator::FrameOrder::kFlight;
  facts.time = scenario.time;
  facts.latency = scenario.time.FromSeconds(scenario.camera.latency_s());
  facts.camera = scenario.assumed_camera();
  facts.pad = scenario.pad;
  const models::Vehicle assumed = scenario.assumed_vehicle();
  facts.mounting = {assumed.X_BC(), assumed.X_BU()};
  facts.estimator = scenario.estimator;
}

}  // namespace touchdown::datasets
