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
  std::vector<std::string> values = {};  ///< Parameter values as YAML, in the order of SweepPlan::keys.
  std::string scenario_yaml = {};        ///< Resolved scenario, with the contents of all referenced files.
  double expected_s = 0.0;               ///< Expected duration in simulated time.
  double limit_s = 0.0;                  ///< Limit of the elapsed time.
};

/// Flights of a sweep, ordered by seed.
struct SweepPlan {
  std::vector<std::string> keys = {};  ///< Keys of the parameters.
  std::vector<PlannedFlight> flights = {};
  std::size_t total = 0;  ///< Number of flights of the whole sweep, of which the plan may be a part.
};

/// Id of a flight: the first 16 hexadecimal digits of the SHA-256 of its resolved scenario, followed by the digest of
/// the program. The resolved scenario includes the seed and the contents of all referenced files.
std::string FlightId(const std::string& scenario_yaml, const std::string& program_digest);

/// Default limit of the elapsed time of a flight, s: a minute plus 30 times the expected duration.
double DefaultLimit_s(const runner::Scenario& scenario);

/// Plans one flight for each combination of seed, listed values and variant, and draws the other values. A drawn value
/// depends only on the seed of the flight and on the key of the parameter. Therefore all flights of a seed have the
/// same value, and a sweep that is extended by seeds keeps its flights. (A Latin hypercube also depends on the number
/// of seeds.) Throws InputError, naming file, line and key, for an invalid scenario, for more than 100,000 flights, and
/// for values or variants that define the same flight twice.
SweepPlan PlanSweep(const SweepFile& file, const std::string& program_digest);

}  // namespace touchdown::sweeper
