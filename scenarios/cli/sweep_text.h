#pragma once

#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::cli {

/// What is planned, and how much of it is flown already.
struct DryRun {
  sweeper::SweepPlan plan = {};
  int jobs = 1;
  int flown = 0;
  double left_s = 0.0;  ///< Expected time in the air of what is yet to be flown.
  /// By the clock, of a second in the air on one core: as the flown ones took, or real time without any.
  double pace = 1.0;
};

/// `rows`: what is in the sweep's folder already; nullptr without one.
DryRun MakeDryRun(const sweeper::SweepPlan& plan, int jobs, const sweeper::SweepStore* rows);

// For people, and as JSON.

std::string DryRunText(const DryRun& dry_run);
std::string DryRunJson(const DryRun& dry_run);

/// `out`: the sweep's folder.
std::string SummaryText(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out);
std::string SummaryJson(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out);

}  // namespace touchdown::cli
