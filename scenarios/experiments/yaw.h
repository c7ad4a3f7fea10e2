#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Yaw from the letter (Sec. IV-C.3): an H turned in steps, image moments, and a rectangle in its place.
Experiment YawExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
