#pragma once

#include "models/describe.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void Describe(models::ConfigVisitor& v, Scenario& scenario);
void Describe(models::ConfigVisitor& v, Start& start);
void Describe(models::ConfigVisitor& v, Criterion& criterion);

/// Describes the key `calibration` of a scenario. Missing keys default to the camera and vehicle of the scenario, which
/// must be read first.
void DescribeCalibration(models::ConfigVisitor& v, Scenario& scenario);

/// Describes a stand-alone calibration. Missing keys of a section have their defaults.
void Describe(models::ConfigVisitor& v, Calibration& calibration);

}  // namespace touchdown::runner
