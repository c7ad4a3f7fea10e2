#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Position and attitude errors over distance and roll (Sec. VI-B.5, Fig. 10), each with its Cramer-Rao bound.
Experiment AccuracyExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
