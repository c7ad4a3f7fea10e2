#pragma once

#include "scenarios/paper/experiment.h"
#include "scenarios/paper/paper_plan.h"

namespace touchdown::scenarios {

/// The measurement that depends on the machine.
inline constexpr char kComputationTimeId[] = "computation_time";

/// What a frame costs over a flight (Sec. VI-B.4, Fig. 9), beside AprilTag 3 on the same frames.
Experiment ComputationTimeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::scenarios
