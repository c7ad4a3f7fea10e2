#pragma once

#include "models/describe.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// Checks what must hold of a scenario's sections together: that the frames come in time, that the floor has room for
/// what lies on it, that start and set-points lie within the room, that events have an effect, and that the script can
/// be flown.
void CheckScenario(models::ConfigVisitor& v, const Scenario& scenario);

}  // namespace touchdown::runner
