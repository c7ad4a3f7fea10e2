#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Yaw from the letter (Sec. IV-C.3): from the ellipse of a rotated H, from image moments, and from a rectangle instead
/// of the H.
Experiment YawExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
