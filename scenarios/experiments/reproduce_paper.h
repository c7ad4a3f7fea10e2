#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/run_measurements.h"

namespace touchdown::experiments {

/// Options of ReproducePaper().
struct ReproductionOptions {
  bool quick = false;  ///< Uses PaperPlan::Quick().
  int jobs = 1;        ///< Maximum number of concurrent measurements.
};

/// Measures all quantities that the paper reports, writes the report to `out`, and returns the rows of the summary.
/// Each result is stored in out/measurements as soon as it is available, and a later call of the same build resumes
/// from there.
///
/// Throws InputError when `out` cannot be written, contains other files, or contains a full run where this one is quick
/// or vice versa. Throws Interrupted when a stop is requested, and rethrows exceptions of the measurements.
std::vector<ComparedQuantity> ReproducePaper(const std::filesystem::path& out, const ReproductionOptions& options,
                                             const util::StopRequested& stop_requested,
                                             const MeasurementProgress& progress);

}  // namespace touchdown::experiments
