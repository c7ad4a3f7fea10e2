#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/experiments/measurement_store.h"

namespace touchdown::experiments {

/// Called after each measurement with the completed fraction of the work, in [0, 1], and the id of the measurement.
using MeasurementProgress = std::function<void(double fraction, const std::string& text)>;

/// Runs the measurements that are not in the store, at most `jobs` concurrently, and returns all results. The longest
/// run first; those that must run alone come last. When a measurement fails or a stop is requested, the running ones
/// are stopped or completed, completed results stay in the store, and the first exception is rethrown: Interrupted, or
/// the exception of the measurement.
Measured RunMeasurements(const std::vector<Measurement>& measurements, const MeasurementStore& store, int jobs,
                         const util::StopRequested& stop_requested, const MeasurementProgress& progress);

}  // namespace touchdown::experiments
