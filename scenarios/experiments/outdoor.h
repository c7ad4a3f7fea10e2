#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Outdoor flight (Sec. VI-C, Fig. 11).
Experiment OutdoorExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
