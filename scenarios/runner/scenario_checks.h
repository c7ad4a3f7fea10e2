#pragma once

#include "models/describe.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// Checks conditions that involve several sections of a scenario: frames arrive in time, the items fit on the floor,
/// start and set-points are in the room, events have an effect, and the script can be flown.
void CheckScenario(models::ConfigVisitor& v, const Scenario& scenario);

}  // namespace touchdown::runner
