#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// The measurement that depends on the machine.
inline constexpr char kComputationTimeId[] = "computation_time";

/// What a frame costs over a flight (Sec. VI-B.4, Fig. 9), beside AprilTag 3 on the same frames.
Experiment ComputationTimeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
