#pragma once

#include "scenarios/datasets/footage.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// Tells of footage of a flight what the flight's estimator was told, all but its frames and samples.
void DescribeFlight(const runner::Scenario& scenario, FootageFacts& facts);

}  // namespace touchdown::datasets
