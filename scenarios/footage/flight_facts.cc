#include "scenarios/footage/flight_facts.h"

namespace touchdown::scenarios {

void TellOfFlight(const Scenario& scenario, FootageFacts& facts) {
  facts.frame_order = estimator::FrameOrder::kFlight;
  facts.time = scenario.time;
  facts.latency = scenario.time.FromSeconds(scenario.camera.latency_s);
  facts.camera = scenario.camera.model;
  facts.pad = scenario.pad;
  facts.mounting = {scenario.vehicle.X_BC(), scenario.vehicle.X_BU()};
  facts.estimator = scenario.estimator;
  facts.attitude_estimator = scenario.attitude_estimator;
}

}  // namespace touchdown::scenarios
