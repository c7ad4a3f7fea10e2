#pragma once

#include <string>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Histogram of a metric that at least one flight has, with the limits of the sweep's criteria.
report::Figure HistogramFigure(const SweepOutcome& sweep, const std::string& metric);

/// Touchdown positions, around a pad of the given radius.
report::Figure TouchdownFigure(const SweepOutcome& sweep, double pad_radius_m);

}  // namespace touchdown::sweeper
