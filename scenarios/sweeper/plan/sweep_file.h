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

/// Listed values of a scenario key. Together with those of other keys they form the grid of the sweep.
struct ListedValues {
  std::vector<std::string> yaml = {};  ///< Numbers in their shortest form.
};

/// A number that is drawn for each seed from the uniform distribution over [min, max).
struct UniformValues {
  double min = 0.0;
  double max = 1.0;
};

/// A number that is drawn for each seed from a normal distribution.
struct NormalValues {
  double mean = 0.0;
  double sigma = 1.0;
};

/// A number in [min, max) that is drawn for each seed by Latin hypercube sampling (McKay, Beckman and Conover 1979).
/// For N seeds, each of N equal intervals contains one value, in a random order for each key.
struct LatinHypercubeValues {
  double min = 0.0;
  double max = 1.0;
};

/// Metric name of a criterion on the pass rate.
inline constexpr std::string_view kPassRate = "pass_rate";

/// Values of one scenario key in a sweep.
struct SweepParameter {
  std::string key = {};
  std::string location = {};          ///< File and line, for messages.
  std::filesystem::path folder = {};  ///< Base folder of file names among its values.
  std::variant<ListedValues, UniformValues, NormalValues, LatinHypercubeValues> values = {};
};

/// A named set of overrides. All variants are flown with the same seeds and values.
struct SweepVariant {
  std::string name = {};
  std::string location = {};  ///< File and line, for messages.
  std::vector<runner::Override> set = {};
};

/// What must be within the limits of a criterion.
enum class JudgedBy {
  kValue,     ///< The measured value.
  kInterval,  ///< The whole 95 % interval.
};
inline constexpr std::array<std::string_view, 2> kJudgedByNames = {"value", "interval"};

/// Criterion of a sweep.
struct SweepCriterion {
  std::string metric = {};  ///< "pass_rate", or a metric of flights.
  /// Quantile of the metric, over the flights that have it; none for the pass rate.
  std::optional<double> quantile = {};
  std::optional<double> min = {};
  std::optional<double> max = {};
  JudgedBy by = JudgedBy::kValue;
};

/// Stopping rule: Wald's sequential probability ratio test of two pass rates.
struct StopWhen {
  double good_pass_rate = 0.99;
  double bad_pass_rate = 0.95;
  double good_refused = 0.05;  ///< Approximate upper bound of the probability of rejecting the good rate.
  double bad_accepted = 0.05;  ///< Approximate upper bound of the probability of accepting the bad rate.
};

/// Seeds from, from + 1, ..., from + count - 1.
struct SweepSeeds {
  std::int64_t from = 1;
  int count = 1;
};

/// Resource limits of a flight of a sweep. A flight that exceeds them is ended and reported as hung or out of memory.
struct FlightLimits {
  std::optional<double> wall_s = {};  ///< Elapsed time; default: DefaultLimit_s.
  int memory_mb = 4096;               ///< Address space.
};

/// Search for the value of a parameter at which the pass rate crosses a level.
struct SearchedBoundary {
  std::string key = {};
  double min = 0.0, max = 1.0;  ///< Bounds of the search.
  double pass_rate = 0.5;
};

/// Contents of a sweep file, such as those in scenarios/sweeps.
struct SweepFile {
  std::string location = {};  ///< Name of the file, for messages.
  std::string name = {};
  std::string description = {};
  std::filesystem::path base = {};  ///< The scenario.
  SweepSeeds seeds = {};
  FlightLimits limits = {};
  std::vector<runner::Override> set = {};  ///< Overrides of the base scenario, for every flight.
  std::vector<SweepParameter> parameters = {};
  std::vector<SweepVariant> variants = {};  ///< One unnamed variant without overrides if the file has no variants.
  std::vector<SweepCriterion> criteria = {};
  std::optional<StopWhen> stop_when = {};
  std::optional<SearchedBoundary> search = {};  ///< Set by FindBoundary, not by a file.
};

/// Converts a YAML value to a number; nullopt if it is not a finite number.
std::optional<double> AsNumber(const std::string& yaml);

/// Reads a sweep file (docs/sweeps.md). Throws InputError, naming file, line and key, for invalid input. PlanSweep
/// checks whether the keys of `parameters` are scenario keys.
SweepFile LoadSweepFile(const std::filesystem::path& file);

}  // namespace touchdown::sweeper
