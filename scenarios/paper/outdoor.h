#pragma once

#include "scenarios/paper/paper_plan.h"
#include "scenarios/paper/section.h"

namespace touchdown::scenarios {

/// The outdoor flight (Sec. VI-C, Fig. 11).
Experiment OutdoorExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
