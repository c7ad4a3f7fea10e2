#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/pass_boundary.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Number of flights and of passes.
struct PassCount {
  int flown = 0;
  int passed = 0;
  std::set<std::uint64_t> seeds = {};

  void Take(std::uint64_t seed, bool has_passed) {
    ++flown;
    passed += has_passed ? 1 : 0;
    seeds.insert(seed);
  }
  /// Pass rate with its Wilson interval; needs at least one flight. The flights of one seed, which have the same floor
  /// and light, count as one.
  util::Interval rate() const { return util::WilsonInterval(passed, flown, static_cast<int>(seeds.size())); }
};

/// Flights with the same value of a parameter, or of the same variant.
struct PassCountOf {
  std::string key = {};    ///< "variant" for the variants.
  std::string value = {};  ///< As YAML.
  PassCount count = {};
};

/// Plan and results of a sweep.
struct SweepOutcome {
  SweepSpec terms = {};
  std::vector<SweepResult> results = {};  ///< Flights of the plan that are flown.
  std::size_t planned = 0;
  std::size_t whole = 0;      ///< Flights of the whole sweep; the plan may be a part of it.
  std::size_t stale = 0;      ///< Flights of another build.
  std::size_t unplanned = 0;  ///< Flights of an earlier version of the sweep file.
};

/// Throws as SweepStore does.
SweepOutcome ReadOutcome(const SweepStore& store);

/// Result of a criterion of the sweep.
struct SweepCheck {
  runner::Check check = {};
  std::optional<util::Interval> interval =
      {};  ///< Interval of the value; an end that the flights do not bound is infinite.
};

/// "0.9933", "good" or "none".
std::string ValueText(const runner::Check& check);

/// Value of a parameter at which the pass rate crosses a level.
struct PassBoundaryOf {
  std::string variant = {};  ///< Empty without variants.
  std::string key = {};
  double pass_rate = 0.5;
  std::optional<util::Interval> edge = {};  ///< nullopt when all flights pass, or all fail.
  bool may_lie_beyond = false;              ///< The boundary may lie beyond the flown values.
};

/// A flight at some value of a parameter, and whether it passed.
struct PassTrial {
  double value = 0.0;
  std::uint64_t seed = 0;
  bool passed = false;
};

struct SweepSummary {
  PassCount all = {};
  std::vector<PassCountOf> by_value = {};  ///< Counts by value, for parameters with listed values.
  std::vector<PassBoundaryOf> edges =
      {};  ///< Boundaries over the searched key, or over the keys that list numbers (PassBoundaryOver).
  std::vector<SweepCheck> criteria = {};  ///< The decision of stop_when first.
  bool is_whole = false;                  ///< Every flight of the whole sweep is flown.

  bool keeps_criteria() const;  ///< Of an incomplete sweep: over the flights so far.
  bool finds_edge() const;      ///< Whether a boundary search found one.
};

/// Pass boundary of a grid: nullopt unless the whole intervals of some rates are above 0.5 and those of others below,
/// and all of the former values are on the same side of the latter.
std::optional<util::Interval> PassBoundaryOver(const std::vector<PassTrial>& trials);

/// A criterion on a metric that no flight has is not met.
SweepSummary Summarize(const SweepOutcome& sweep);

/// Whether an axis has at least two listed values, all of them numbers.
bool IsNumeric(const SweepAxis& axis);

/// Counts the flights for which `belongs` is true.
template <typename Belongs>
PassCount CountWhere(const std::vector<SweepResult>& results, const Belongs& belongs) {
  PassCount count;
  for (const SweepResult& result : results) {
    if (belongs(result)) count.Take(result.seed, result.row.passed());
  }
  return count;
}

/// Number of flights whose process ended this way.
int CountEnds(const std::vector<SweepResult>& results, ProcessEnd end);
/// Counts of processes that crashed, hung or ran out of memory ("2 crashed, 1 hung"); empty when none did.
std::string LostProcesses(const std::vector<SweepResult>& results);

/// Values of a metric, of the flights that have it.
std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric);

}  // namespace touchdown::sweeper
