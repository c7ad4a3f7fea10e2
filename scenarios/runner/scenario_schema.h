#pragma once

#include "models/describe.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void Describe(models::ConfigVisitor& v, Scenario& scenario);
void Describe(models::ConfigVisitor& v, Start& start);
void Describe(models::ConfigVisitor& v, Criterion& criterion);

/// The key `calibration` of a scenario. Keys that it leaves out are those of the scenario's camera and vehicle, so they
/// must be final before it is read.
void DescribeCalibration(models::ConfigVisitor& v, Scenario& scenario);

/// The keys of a calibration that is read alone. Keys that a section leaves out have their defaults.
void Describe(models::ConfigVisitor& v, Calibration& calibration);

}  // namespace touchdown::runner
