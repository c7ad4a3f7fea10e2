#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Rate at which gravity selects the wrong one of the two pose hypotheses of the circle (Sec. IV-C.2), and the fraction
/// of wrong selections that the outlier gate rejects.
Experiment AmbiguityExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
