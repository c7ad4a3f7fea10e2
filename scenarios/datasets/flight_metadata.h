#pragma once

#include "scenarios/datasets/footage.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// Sets the estimator inputs of a flight in the metadata of its footage, except for the IMU samples.
void SetFlightMetadata(const runner::Scenario& scenario, FootageMetadata& metadata);

}  // namespace touchdown::datasets
