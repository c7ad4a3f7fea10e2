#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// True vehicle of the paper's experiments. Camera and IMU deviate from their nominal mountings; the camera has "a
/// small tilt in pitch angle" (Sec. VI-B.5).
models::Vehicle TrueVehicle();

/// The calibrations of Sec. III-D and their errors, for several seeds.
Experiment CalibrationsExperiment(const PaperPlan& plan);

/// Result of the first calibration, which all flights use.
runner::Calibration CalibrationOf(const Measured& measured);

}  // namespace touchdown::experiments
