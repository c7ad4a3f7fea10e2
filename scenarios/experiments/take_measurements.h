#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/experiments/measurement_store.h"

namespace touchdown::experiments {

/// Told after each measurement: the share of the whole that is done, in [0, 1], and what was done last.
using MeasurementProgress = std::function<void(double share, const std::string& text)>;

/// Takes what the store does not hold yet, `jobs` at a time, the longest first, those that must be alone last, and
/// returns all. When one fails, or a stop is requested, those that are running are stopped or finished, what is done
/// stays in the store, and the first exception is thrown again: Interrupted, or what the measurement threw.
Measured TakeMeasurements(const std::vector<Measurement>& measurements, const MeasurementStore& store, int jobs,
                          const util::StopRequested& stop_requested, const MeasurementProgress& progress);

}  // namespace touchdown::experiments
