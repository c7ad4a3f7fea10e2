#pragma once

#include <optional>
#include <string>

#include "scenarios/cli/output.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::cli {

/// Where a sweep's results go: the page lies in its folder.
struct SweepFiles {
  std::string folder = {};
  std::optional<std::string> csv = {};
};

/// Throws InputError when a file is there already that this program has not made.
void CheckSweepFiles(const SweepFiles& files);

/// Prints the summary of what is flown, and writes its CSV and its page. A page that cannot be drawn is a warning: it
/// does not make a sweep of hours fail. Throws InputError when a file cannot be written.
sweeper::SweepSummary ReportOutcome(const SweepFiles& files, const OutputOptions& output);

}  // namespace touchdown::cli
