#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// How often gravity chooses the wrong one of the circle's two poses (Sec. IV-C.2), and what the outlier rule catches.
Experiment AmbiguityExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
