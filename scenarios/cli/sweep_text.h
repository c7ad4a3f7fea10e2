#pragma once

#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::cli {

/// A planned sweep, and how much of it is flown.
struct DryRun {
  sweeper::SweepPlan plan = {};
  int jobs = 1;
  int flown = 0;
  double left_s = 0.0;  ///< Expected simulated time of the flights that are not flown yet, s.
  double pace = 1.0;    ///< Wall-clock time per simulated time on one core, from the flown rows; 1 without any.
};

/// `rows` are the rows in the sweep's output directory, or nullptr if there is no such directory.
DryRun MakeDryRun(const sweeper::SweepPlan& plan, int jobs, const sweeper::SweepStore* rows);

/// The dry run as readable text, and as JSON.
std::string DryRunText(const DryRun& dry_run);
std::string DryRunJson(const DryRun& dry_run);

/// The results of a sweep as readable text, and as JSON. `out` is the sweep's output directory.
std::string SummaryText(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out);
std::string SummaryJson(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out);

}  // namespace touchdown::cli
