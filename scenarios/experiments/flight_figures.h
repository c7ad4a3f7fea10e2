#pragma once

#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/report/figure.h"

namespace touchdown::experiments {

/// Position and attitude over time as the paper draws a flight: vision red, tracking system green, truth a thin line.
/// `series` is FlyAndSumUp's.
std::vector<report::Figure> FlightFigures(const std::string& name, const std::string& title, const Json& series);

}  // namespace touchdown::experiments
