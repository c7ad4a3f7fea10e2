#pragma once

#include <string>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::sweeper {

/// Phase of the flight in which a check failed: for errors of vision, the phase with the largest part of them; for
/// metrics of the touchdown, `touchdown`; for all others, the last phase before the flight ended or control was handed
/// over.
std::string FailurePhase(const runner::Check& check, const runner::FlightLog& log);

}  // namespace touchdown::sweeper
