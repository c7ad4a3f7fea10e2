#pragma once

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

/// Approximate duration, s, of a flight that completes its script; at most the time limit. It is used for progress
/// reports; the actual duration may differ.
double ExpectedDuration_s(const Scenario& scenario);

}  // namespace touchdown::runner
