#pragma once

#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/report/figure.h"

namespace touchdown::experiments {

/// Figures of position and attitude over time in the style of the paper: vision orange, tracking system green, truth as
/// a thin line. `series` is the entry "series" of FlyAndSummarize().
std::vector<report::Figure> FlightFigures(const std::string& name, const std::string& title, const Json& series);

}  // namespace touchdown::experiments
