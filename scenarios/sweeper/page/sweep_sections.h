#pragma once

#include <vector>

#include "scenarios/report/section.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Sections of a sweep's page, without its head and its list of failures. Empty sections are left out.
std::vector<report::ReportSection> SweepSections(const SweepOutcome& sweep, const SweepSummary& summary);

/// Reason why a flight did not pass, in a few words: end of its process, outcome, or criterion and phase.
std::string CauseOf(const FlightRow& row);

/// A pass rate and its interval in percent: "75.0" and "30.1–95.4".
std::string RateText(const PassCount& count);
std::string RateInterval(const PassCount& count);

}  // namespace touchdown::sweeper
