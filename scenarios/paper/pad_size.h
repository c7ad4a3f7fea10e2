#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// Working distance against blind range for pads of other radii (Sec. III-B).
Experiment PadSizeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
