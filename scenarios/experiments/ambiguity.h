#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// How often gravity chooses the wrong one of the circle's two poses (Sec. IV-C.2), and what the outlier rule catches.
Experiment AmbiguityExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
