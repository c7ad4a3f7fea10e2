#pragma once

#include <string>

#include "scenarios/flight/flight_log.h"
#include "scenarios/flight/metrics.h"

namespace touchdown::scenarios {

/// The phase of the flight in which a check that was not kept went wrong: of vision's errors the phase with the largest
/// share of them, of what is measured at touchdown `touchdown`, of all else the last phase before the flight ended or
/// control was handed over.
std::string FailurePhase(const Check& check, const FlightLog& log);

}  // namespace touchdown::scenarios
