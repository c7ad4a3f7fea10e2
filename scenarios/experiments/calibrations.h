#pragma once

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// The vehicle of the paper's experiments as it truly is: camera and IMU a little off their nominal mountings, the
/// camera with "a small tilt in pitch angle" (Sec. VI-B.5).
models::Vehicle TrueVehicle();

/// The calibrations (Sec. III-D), for several seeds: found, true, and apart.
Experiment CalibrationsExperiment(const PaperPlan& plan);

/// What the first of them found: this is what all flights are flown with.
runner::Calibration CalibrationOf(const Measured& measured);

}  // namespace touchdown::experiments
