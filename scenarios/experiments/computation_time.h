#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Id of the measurement that depends on the computer.
inline constexpr char kComputationTimeId[] = "computation_time";

/// Computation time per frame during a flight (Sec. VI-B.4, Fig. 9), compared with AprilTag 3 on the same frames.
Experiment ComputationTimeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

}  // namespace touchdown::experiments
