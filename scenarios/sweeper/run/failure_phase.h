#pragma once

#include <string>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::sweeper {

/// The phase of the flight in which a check that was not kept went wrong: of vision's errors the phase with the largest
/// share of them, of what is measured at touchdown `touchdown`, of all else the last phase before the flight ended or
/// control was handed over.
std::string FailurePhase(const runner::Check& check, const runner::FlightLog& log);

}  // namespace touchdown::sweeper
