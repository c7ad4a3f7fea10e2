#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/pass_boundary.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Number of flights and of passed flights.
struct PassCount {
  int flown = 0;
  int passed = 0;
  std::set<std::uint64_t> seeds = {};

  /// Counts a flight.
  void Add(std::uint64_t seed, bool has_passed) {
    ++flown;
    passed += has_passed ? 1 : 0;
    seeds.insert(seed);
  }
  /// Pass rate with its Wilson interval, over at least one flight. The flights of a seed have the same floor and light,
  /// so for the interval they count as one.
  util::Interval rate() const { return util::WilsonInterval(passed, flown, static_cast<int>(seeds.size())); }
};

/// Number of flights with the same value of a parameter, or of the same variant.
struct PassCountOf {
  std::string key = {};    ///< Key of the parameter; "variant" for a variant.
  std::string value = {};  ///< Value as YAML, or name of the variant.
  PassCount count = {};
};

/// Plan and results of a sweep.
struct SweepOutcome {
  SweepSpec spec = {};
  std::vector<SweepResult> results = {};  ///< Results of the planned flights that have a row.
  std::size_t planned = 0;
  std::size_t total = 0;      ///< Number of flights of the whole sweep, of which the plan may be a part.
  std::size_t stale = 0;      ///< Number of rows of other builds.
  std::size_t unplanned = 0;  ///< Number of rows from earlier versions of the sweep file.
};

/// Reads plan and results from the database. Throws as SweepStore does.
SweepOutcome ReadOutcome(const SweepStore& store);

/// Result of a criterion of the sweep.
struct SweepCheck {
  runner::Check check = {};
  /// 95 % interval of the value; a bound that the flights do not determine is infinite.
  std::optional<util::Interval> interval = {};
};

/// Value of a check as text, such as "0.9933" or "good"; "none" without a value.
std::string ValueText(const runner::Check& check);

/// Pass boundary of a parameter: the value at which the pass rate crosses a level.
struct PassBoundaryOf {
  std::string variant = {};  ///< Empty without variants.
  std::string key = {};
  double pass_rate = 0.5;
  std::optional<util::Interval> boundary = {};  ///< With 95 % interval; nullopt if all flights pass or all fail.
  bool may_lie_beyond = false;                  ///< Whether the boundary may be outside the range of the values.
};

/// Outcome of a flight at a value of a parameter.
struct PassTrial {
  double value = 0.0;
  std::uint64_t seed = 0;
  bool passed = false;
};

/// Statistics and checks of a sweep.
struct SweepSummary {
  PassCount all = {};
  std::vector<PassCountOf> by_value = {};  ///< Counts by value, for parameters with listed values.
  /// Boundary of the searched key, or of the keys that list numbers (PassBoundaryOver).
  std::vector<PassBoundaryOf> boundaries = {};
  std::vector<SweepCheck> criteria = {};  ///< The decision of stop_when first, if any.
  bool is_complete = false;               ///< Whether all flights of the whole sweep are flown.

  bool meets_criteria() const;  ///< Whether all criteria are met, by the flights so far.
  bool finds_boundary() const;  ///< Whether a pass boundary was found.
};

/// Pass boundary over a grid of values, at a pass rate of 0.5, with its 95 % interval. nullopt unless the whole
/// intervals of some rates are above 0.5 and those of others below it, with all the passing values on one side of the
/// failing ones.
std::optional<util::Interval> PassBoundaryOver(const std::vector<PassTrial>& trials);

/// Evaluates the results of a sweep. A criterion on a metric that no flight has is not met.
SweepSummary Summarize(const SweepOutcome& sweep);

/// Whether an axis has at least two listed values, all of them numbers.
bool IsNumeric(const SweepAxis& axis);

/// Counts the flights for which `belongs` is true.
template <typename Belongs>
PassCount CountWhere(const std::vector<SweepResult>& results, const Belongs& belongs) {
  PassCount count;
  for (const SweepResult& result : results) {
    if (belongs(result)) count.Add(result.seed, result.row.passed());
  }
  return count;
}

/// Number of flights whose process had this end.
int CountEnds(const std::vector<SweepResult>& results, ProcessEnd end);
/// Numbers of processes that crashed, hung or ran out of memory as text, such as "2 crashed, 1 hung"; empty if none.
std::string FailedProcesses(const std::vector<SweepResult>& results);

/// Values of a metric, over the flights that have it.
std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric);

}  // namespace touchdown::sweeper
