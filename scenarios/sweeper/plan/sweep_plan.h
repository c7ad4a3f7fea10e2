#pragma once

#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// A planned flight of a sweep.
struct PlannedFlight {
  std::int64_t position = 0;  ///< Position in the whole sweep.
  std::string id = {};        ///< See FlightId.
  std::uint64_t seed = 0;
  std::string variant = {};              ///< Empty without variants.
  std::vector<std::string> values = {};  ///< As YAML, in the order of SweepPlan::keys.
  std::string scenario_yaml = {};        ///< Resolved scenario, with the contents of every file that it names.
  double expected_s = 0.0;               ///< Expected duration, simulated time.
  double limit_s = 0.0;                  ///< Limit of the wall-clock time.
};

/// Flights of a sweep, in order: all of the first seed, then all of the next.
struct SweepPlan {
  std::vector<std::string> keys = {};  ///< Keys of the parameters.
  std::vector<PlannedFlight> flights = {};
  std::size_t whole = 0;  ///< Flights of the whole sweep; the plan may be a part of it.
};

/// The identity of a flight: 16 hexadecimal digits of SHA-256 of the resolved scenario, which holds its seed and the
/// contents of every file that it names, and of the program that flies it.
std::string FlightId(const std::string& scenario_yaml, const std::string& program_digest);

/// Default limit of the wall-clock time of a flight, far above the usual time.
double DefaultLimit_s(const runner::Scenario& scenario);

/// Crosses seeds, variants and listed values, and draws the others: a drawn value depends on the flight's seed and the
/// parameter's key, only, so that all flights of a seed have the same value, and an extended sweep keeps its flights.
/// (Latin hypercubes depend on the number of seeds, too.) Throws InputError, naming file, line and key, for an invalid
/// scenario, and for values and variants that define the same flight twice.
SweepPlan PlanSweep(const SweepFile& file, const std::string& program_digest);

}  // namespace touchdown::sweeper
