#pragma once

#include <string>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::sweeper {

/// Phase of the flight in which a check failed. For metrics of vision it is the phase that contributes most to the
/// error, for metrics of the touchdown it is `touchdown`, and for all others the last phase before the flight ended or
/// the guidance gave up. Empty for a flight without ticks.
std::string FailurePhase(const runner::Check& check, const runner::FlightLog& log);

}  // namespace touchdown::sweeper
