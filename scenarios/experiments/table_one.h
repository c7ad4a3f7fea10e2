#pragma once

#include <string>

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// The hand-held motion, the disturbed hover and the autonomous flight (Sec. VI-B.1 to 3, Figs. 6 to 8, Table I), each
/// flown for several seeds.
Experiment TableOneExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

/// Table I, published and measured side by side, for a LaTeX document.
std::string TableOneLatex(const PaperPlan& plan, const Measured& measured);

/// The ids of the autonomous flights: ten landings in a row.
std::vector<std::string> AutonomousFlightIds(const PaperPlan& plan);

}  // namespace touchdown::experiments
