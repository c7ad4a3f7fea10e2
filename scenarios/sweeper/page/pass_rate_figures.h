#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Plots the pass rate of each variant over an axis that lists numbers, with the pass boundaries.
report::Figure PassRateFigure(const SweepOutcome& sweep, std::size_t axis,
                              const std::vector<PassBoundaryOf>& boundaries);

/// Draws a heat map of the pass rate of a variant over two axes. The cells of an axis are its listed values, or five
/// equal intervals of its drawn values.
report::Figure HeatMapFigure(const SweepOutcome& sweep, std::size_t axis_x, std::size_t axis_y,
                             const std::string& variant);

/// Plots the passed and failed flights of all variants over an axis with drawn values, with the pass boundaries. With
/// 25 or more flights it also plots the pass rate of five groups of equal size.
report::Figure DrawnValuesFigure(const SweepOutcome& sweep, std::size_t axis,
                                 const std::vector<PassBoundaryOf>& boundaries);

}  // namespace touchdown::sweeper
