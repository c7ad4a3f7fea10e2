#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Position and attitude errors over distances and roll angles (Sec. VI-B.5, Fig. 10), each beside the Cramer-Rao
/// limit.
Experiment AccuracyExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
