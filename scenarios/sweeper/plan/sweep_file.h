#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scenarios/runner/scenario.h"

namespace touchdown::sweeper {

/// Values of a scenario key, each flown: crossed with those of other keys they make the sweep's grid.
struct ListedValues {
  std::vector<std::string> yaml = {};  ///< Numbers in their shortest form.
};

/// A number that is drawn for each seed, uniformly in [min, max).
struct UniformValues {
  double min = 0.0;
  double max = 1.0;
};

/// A number that is drawn for each seed from a normal distribution.
struct NormalValues {
  double mean = 0.0;
  double sigma = 1.0;
};

/// A number that is drawn for each seed, in [min, max), so that each of as many equal parts of it as there are seeds
/// is met once, in an order of its own for each key (McKay, Beckman and Conover 1979).
struct LatinHypercubeValues {
  double min = 0.0;
  double max = 1.0;
};

/// The name of the criterion on the share of flights that pass.
inline constexpr std::string_view kPassRate = "pass_rate";

/// What a sweep does with one key of the scenario.
struct SweepParameter {
  std::string key = {};
  std::string place = {};             ///< Where it was written, for messages.
  std::filesystem::path folder = {};  ///< That names of files among its values are meant from.
  std::variant<ListedValues, UniformValues, NormalValues, LatinHypercubeValues> values = {};
};

/// A setting that is flown beside others on the same seeds and values.
struct SweepVariant {
  std::string name = {};
  std::string place = {};  ///< Where it was written, for messages.
  std::vector<runner::Override> set = {};
};

/// What of a sweep's figure must be within a criterion's limits.
enum class JudgedBy {
  kValue,     ///< What was measured.
  kInterval,  ///< The whole 95 % interval, so that the flights prove it.
};
inline constexpr std::array<std::string_view, 2> kJudgedByNames = {"value", "interval"};

/// A demand on the sweep as a whole.
struct SweepCriterion {
  std::string metric = {};              ///< "pass_rate", or a flight's.
  std::optional<double> quantile = {};  ///< Of a flight's metric, over the flights that have it.
  std::optional<double> min = {};
  std::optional<double> max = {};
  JudgedBy by = JudgedBy::kValue;
};

/// When enough has been flown: Wald's sequential probability ratio test of two pass rates.
struct StopWhen {
  double good_pass_rate = 0.99;
  double bad_pass_rate = 0.95;
  double good_refused = 0.05;  ///< Chance of calling a sweep of the good rate bad, at most, about.
  double bad_accepted = 0.05;  ///< Chance of calling one of the bad rate good.
};

struct SweepSeeds {
  std::int64_t from = 1;
  int count = 1;
};

/// Limits of a flight of a sweep. A flight beyond them is ended and reported as hung or out of memory.
struct FlightLimits {
  std::optional<double> wall_s = {};  ///< Default: see SweepPlan.
  int memory_mb = 4096;
};

/// The value of a parameter at which the pass rate goes through a level.
struct SearchedBoundary {
  std::string key = {};
  double min = 0.0, max = 1.0;  ///< Between which it is sought.
  double pass_rate = 0.5;
};

/// Flights to fly, as read from a file of scenarios/sweeps.
struct SweepFile {
  std::string place = {};  ///< The file itself, for messages.
  std::string name = {};
  std::string description = {};
  std::filesystem::path base = {};  ///< The scenario.
  SweepSeeds seeds = {};
  FlightLimits limits = {};
  std::vector<runner::Override> set = {};  ///< Over the base, of every flight.
  std::vector<SweepParameter> parameters = {};
  std::vector<SweepVariant> variants = {};  ///< One of no name that sets nothing when the file has none.
  std::vector<SweepCriterion> criteria = {};
  std::optional<StopWhen> stop_when = {};
  std::optional<SearchedBoundary> sought = {};  ///< Of no file: see FindBoundary.
};

/// The number that a value is; nullopt for one that is none.
std::optional<double> AsNumber(const std::string& yaml);

/// Throws InputError, naming file, line and key, for anything that is not as docs/sweeps.md has it. That the keys of
/// `parameters` are a scenario's is seen when the flights are planned (PlanSweep).
SweepFile LoadSweepFile(const std::filesystem::path& file);

}  // namespace touchdown::sweeper
