#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/report/figure.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// The pass rate of each variant over a parameter of the sweep's axes that lists numbers, and the edges over it.
report::Figure PassRateFigure(const SweepOutcome& sweep, std::size_t axis, const std::vector<PassBoundaryOf>& edges);

/// The pass rate of a variant over two parameters of the sweep's axes: over their listed values, or the ranges that
/// hold the drawn.
report::Figure HeatMapFigure(const SweepOutcome& sweep, std::size_t axis_x, std::size_t axis_y,
                             const std::string& variant);

/// Which flights, of all variants, passed over a parameter of the sweep's axes whose values are drawn; with many
/// flights also the rate within five groups of as many each; and the edges over it.
report::Figure DrawnValuesFigure(const SweepOutcome& sweep, std::size_t axis, const std::vector<PassBoundaryOf>& edges);

}  // namespace touchdown::sweeper
