#pragma once

#include <string>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Draws a histogram of a metric, with the limits of the sweep's criteria. At least one flight must have the metric.
report::Figure HistogramFigure(const SweepOutcome& sweep, const std::string& metric);

/// Plots the touchdown positions, with the ring of a pad of the given radius, m.
report::Figure TouchdownFigure(const SweepOutcome& sweep, double pad_radius_m);

}  // namespace touchdown::sweeper
