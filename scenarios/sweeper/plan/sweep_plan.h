#pragma once

#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// A flight that a sweep is to fly.
struct PlannedFlight {
  std::int64_t position = 0;  ///< In the whole sweep.
  std::string id = {};        ///< See FlightId.
  std::uint64_t seed = 0;
  std::string variant = {};              ///< Empty without variants.
  std::vector<std::string> values = {};  ///< As YAML, in the order of SweepPlan::keys.
  std::string scenario_yaml = {};        ///< The whole scenario, every file that it names in place.
  double expected_s = 0.0;               ///< How long it flies, in simulated time.
  double limit_s = 0.0;                  ///< By the wall clock.
};

/// What a sweep flies, in the order in which it does: all of the first seed, then all of the next.
struct SweepPlan {
  std::vector<std::string> keys = {};  ///< Of the parameters.
  std::vector<PlannedFlight> flights = {};
  std::size_t whole = 0;  ///< Flights of the whole sweep, of which these may be a part.
};

/// The identity of a flight: 16 hexadecimal digits of SHA-256 of the resolved scenario, which holds its seed and the
/// contents of every file that it names, and of the program that flies it.
std::string FlightId(const std::string& scenario_yaml, const std::string& program_digest);

/// What a flight may take by the wall clock unless somebody says otherwise: far more than any should.
double DefaultLimit_s(const runner::Scenario& scenario);

/// Crosses seeds, variants and listed values, and draws the others: a drawn value depends on the flight's seed and the
/// parameter's key, and on nothing else, so that all of a seed's flights share it and a sweep that grows keeps its
/// flights. (Latin hypercubes depend on the count of seeds too.) Throws InputError, naming file, line and key, for what
/// is no valid scenario, and for values and variants that make the same flight twice.
SweepPlan PlanSweep(const SweepFile& file, const std::string& program_digest);

}  // namespace touchdown::sweeper
