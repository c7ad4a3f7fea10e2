#pragma once

#include <optional>
#include <string>

#include "scenarios/cli/output_options.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::cli {

/// Output files of a sweep.
struct SweepFiles {
  std::string folder = {};              ///< Output directory with the rows and the report page.
  std::optional<std::string> csv = {};  ///< File for the rows as CSV.
};

/// Throws InputError when one of the files exists and was not written by this program.
void CheckSweepFiles(const SweepFiles& files);

/// Prints the summary of the rows in the output directory, and writes the CSV file and the report page. A page that
/// cannot be rendered is only a warning, so that a sweep of hours does not fail. Throws InputError when a file cannot
/// be written.
sweeper::SweepSummary ReportOutcome(const SweepFiles& files, const OutputOptions& output);

}  // namespace touchdown::cli
