#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Working distance and blind range over the radius of the pad (Sec. III-B).
Experiment PadSizeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
