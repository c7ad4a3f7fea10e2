#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// Yaw from the letter (Sec. IV-C.3): an H turned in steps, image moments, and a rectangle in its place.
Experiment YawExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
