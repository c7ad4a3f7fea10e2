#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// The outdoor flight (Sec. VI-C, Fig. 11).
Experiment OutdoorExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
