#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Landing pad recognition (Secs. IV-A and VI-A, Figs. 2, 4 and 5): example images, false positives, recall.
Experiment RecognitionExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
