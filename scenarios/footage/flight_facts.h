#pragma once

#include "scenarios/flight/scenario.h"
#include "scenarios/footage/footage.h"

namespace touchdown::scenarios {

/// Tells of footage of a flight what the flight's estimator was told, all but its frames and samples.
void TellOfFlight(const Scenario& scenario, FootageFacts& facts);

}  // namespace touchdown::scenarios
