#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/pass_edge.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// How many of some flights passed.
struct PassCount {
  int flown = 0;
  int passed = 0;
  std::set<std::uint64_t> seeds = {};

  void Take(std::uint64_t seed, bool has_passed) {
    ++flown;
    passed += has_passed ? 1 : 0;
    seeds.insert(seed);
  }
  /// The share with its Wilson interval, of at least one flight. The flights of one seed, over the same floor in the
  /// same light, count as a single one.
  util::Interval rate() const { return util::WilsonInterval(passed, flown, static_cast<int>(seeds.size())); }
};

/// The flights that share a value of a parameter, or a variant.
struct PassCountOf {
  std::string key = {};    ///< "variant" for the variants.
  std::string value = {};  ///< As YAML.
  PassCount count = {};
};

/// All that is known of a sweep.
struct SweepOutcome {
  SweepSpec terms = {};
  std::vector<SweepResult> results = {};  ///< What is flown of the plan.
  std::size_t planned = 0;
  std::size_t whole = 0;      ///< Flights of the whole sweep, of which those planned here may be a part.
  std::size_t stale = 0;      ///< Flights of another build.
  std::size_t unplanned = 0;  ///< Flights of what the sweep's file was before.
};

/// Throws as SweepStore does.
SweepOutcome ReadOutcome(const SweepStore& store);

/// What became of a criterion on the sweep.
struct SweepCheck {
  runner::Check check = {};
  std::optional<util::Interval> interval =
      {};  ///< Interval of the value; an end that the flights do not bound is infinite.
};

/// "0.9933", "good" or "none".
std::string ValueText(const runner::Check& check);

/// Where the pass rate goes through a level over a parameter.
struct PassBoundaryOf {
  std::string variant = {};  ///< Empty without variants.
  std::string key = {};
  double pass_rate = 0.5;
  std::optional<util::Interval> edge = {};  ///< nullopt for one that was sought where all flights pass, or all fail.
  bool may_lie_beyond = false;              ///< The flown values.
};

/// A flight at some value of a parameter, and whether it passed.
struct PassTrial {
  double value = 0.0;
  std::uint64_t seed = 0;
  bool passed = false;
};

struct SweepSummary {
  PassCount all = {};
  std::vector<PassCountOf> by_value = {};  ///< Of keys with a few values each: those that are listed, not drawn.
  std::vector<PassBoundaryOf> edges =
      {};  ///< Of the key that was sought, or of those that list numbers (PassBoundaryOver).
  std::vector<SweepCheck> criteria = {};  ///< The decision of stop_when first.
  bool is_whole = false;                  ///< Every flight of the whole sweep is flown.

  bool keeps_criteria() const;  ///< What is said of a sweep that is not whole is said of what is flown.
  bool finds_edge() const;      ///< Of a sweep that sought one.
};

/// The edge between values that flights pass at and values that they fail at, of a grid: nullopt unless the rates of
/// some values lie above a half with their whole intervals and those of others below, and each of the ones lies on the
/// same side of all of the others.
std::optional<util::Interval> PassBoundaryOver(const std::vector<PassTrial>& trials);

/// A criterion on a metric that no flight has is not kept.
SweepSummary Summarize(const SweepOutcome& sweep);

/// With at least two listed values, all of them numbers.
bool IsNumeric(const SweepAxis& axis);

/// Of the flights to which `belongs` applies.
template <typename Belongs>
PassCount CountWhere(const std::vector<SweepResult>& results, const Belongs& belongs) {
  PassCount count;
  for (const SweepResult& result : results) {
    if (belongs(result)) count.Take(result.seed, result.row.passed());
  }
  return count;
}

/// How many flights' processes ended so.
int CountEnds(const std::vector<SweepResult>& results, ProcessEnd end);
/// How many crashed, hung or ran out of memory, as in "2 crashed, 1 hung"; empty when none did.
std::string LostProcesses(const std::vector<SweepResult>& results);

/// Of the flights that have it.
std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric);

}  // namespace touchdown::sweeper
