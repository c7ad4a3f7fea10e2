#pragma once

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// Approximate duration of a flight that follows its script, s; at most its time limit. It is used for progress
/// reports; the actual duration may differ.
double ExpectedDuration_s(const Scenario& scenario);

}  // namespace touchdown::runner
