#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/take_measurements.h"

namespace touchdown::experiments {

struct ReproductionOptions {
  bool quick = false;
  int jobs = 1;
};

/// Measures everything that the paper reports and leaves the report in `out`. What is measured is kept in
/// out/measurements as soon as it is done: called again, the same program goes on from there. Throws InputError when
/// `out` holds anything else, be it a quick run where this one is full, or cannot be written, Interrupted when a stop
/// was requested, and what a measurement throws. Returns the lines of the summary.
std::vector<ComparedQuantity> ReproducePaper(const std::filesystem::path& out, const ReproductionOptions& options,
                                             const util::StopRequested& stop_requested,
                                             const MeasurementProgress& progress);

}  // namespace touchdown::experiments
