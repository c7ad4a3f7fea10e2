#pragma once

#include <string>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// How often a metric, which at least one flight has, had which values, and the limits of the sweep's criteria on it.
report::Figure HistogramFigure(const SweepOutcome& sweep, const std::string& metric);

/// Where the flights touched down, around a pad of that radius.
report::Figure TouchdownFigure(const SweepOutcome& sweep, double pad_radius_m);

}  // namespace touchdown::sweeper
