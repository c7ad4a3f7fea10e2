#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Pass rate of each variant over an axis that lists numbers, with the pass boundaries.
report::Figure PassRateFigure(const SweepOutcome& sweep, std::size_t axis, const std::vector<PassBoundaryOf>& edges);

/// Pass rate of a variant over two axes: over their listed values, or over ranges of the drawn values.
report::Figure HeatMapFigure(const SweepOutcome& sweep, std::size_t axis_x, std::size_t axis_y,
                             const std::string& variant);

/// Passed and failed flights of all variants over an axis with drawn values, with the pass boundaries; with many
/// flights also the rate within five groups of equal size.
report::Figure DrawnValuesFigure(const SweepOutcome& sweep, std::size_t axis, const std::vector<PassBoundaryOf>& edges);

}  // namespace touchdown::sweeper
