#pragma once

#include <string>

#include "scenarios/experiments/experiment.h"
#include "scenarios/experiments/paper_plan.h"

namespace touchdown::experiments {

/// Hand-held motion, disturbed hover and autonomous flight (Sec. VI-B.1 to 3, Figs. 6 to 8, Table I), each with several
/// seeds.
Experiment TableOneExperiment(const PaperPlan& plan, const PaperVehicle& vehicle);

/// Table I with published and measured values, in LaTeX.
std::string TableOneLatex(const PaperPlan& plan, const Measured& measured);

/// Measurement ids of the autonomous flights, which are the consecutive landings of Sec. VI-B.3.
std::vector<std::string> AutonomousFlightIds(const PaperPlan& plan);

}  // namespace touchdown::experiments
