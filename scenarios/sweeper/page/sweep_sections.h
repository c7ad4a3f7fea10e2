#pragma once

#include <vector>

#include "scenarios/report/section.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Sections of a sweep page, without its header and its list of failures. Empty sections are omitted.
std::vector<report::ReportSection> SweepSections(const SweepOutcome& sweep, const SweepSummary& summary);

/// Short reason why a flight did not pass: the end of its process, the outcome, or the criterion, with the phase.
std::string CauseOf(const FlightRow& row);

/// Pass rate in percent, such as "75.0".
std::string RateText(const PassCount& count);
/// 95 % interval of the pass rate in percent, such as "30.1–95.4".
std::string RateInterval(const PassCount& count);

}  // namespace touchdown::sweeper
