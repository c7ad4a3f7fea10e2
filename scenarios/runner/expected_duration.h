#pragma once

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// About how long a flight will take that goes as its script wants it, s; at most its time limit. For telling how far
/// it is: a flight may take another time.
double ExpectedDuration_s(const Scenario& scenario);

}  // namespace touchdown::runner
