#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// Landing pad recognition (Secs. IV-A and VI-A, Figs. 2, 4 and 5): pictures, false positives, recall.
Experiment RecognitionExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
