#pragma once

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// Approximate duration of a flight that follows its script, s; at most its time limit. For reporting how far
/// it is: a flight may take another time.
double ExpectedDuration_s(const Scenario& scenario);

}  // namespace touchdown::runner
