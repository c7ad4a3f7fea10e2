#include "scenarios/sweeper/analysis/sweep_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "scenarios/sweeper/analysis/sprt.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

constexpr double kBoundaryPassRate = 0.5;

std::vector<PassCountOf> CountsByValue(const SweepSpec& spec, const std::vector<SweepResult>& results) {
  std::vector<PassCountOf> counts;
  const auto add = [&](const std::string& key, const std::string& value, const auto& belongs) {
    const PassCount count = CountWhere(results, belongs);
    if (count.flown > 0) counts.push_back({key, value, count});
  };
  for (const std::string& variant : spec.variants) {
    add("variant", variant, [&](const SweepResult& result) { return result.variant == variant; });
  }
  for (std::size_t i = 0; i < spec.axes.size(); ++i) {
    for (const std::string& value : spec.axes[i].listed) {
      add(spec.axes[i].key, value, [&](const SweepResult& result) { return result.values[i] == value; });
    }
  }
  return counts;
}

/// Measured value of a criterion with its 95 % interval; nullopt if no flight has the metric.
std::optional<util::Interval> StatisticOf(const SweepCriterion& criterion, const std::vector<SweepResult>& results,
                                          const PassCount& all) {
  if (!criterion.quantile) return all.flown > 0 ? std::optional(all.rate()) : std::nullopt;
  std::vector<SweepResult> with_metric;
  std::copy_if(results.begin(), results.end(), std::back_inserter(with_metric),
               [&](const SweepResult& result) { return result.row.metrics.contains(criterion.metric); });
  if (with_metric.empty()) return std::nullopt;
  const PassCount count = CountWhere(with_metric, [](const SweepResult&) { return true; });
  return util::QuantileInterval(MetricValues(with_metric, criterion.metric), *criterion.quantile,
                                static_cast<int>(count.seeds.size()));
}

SweepCheck Judged(const SweepCriterion& criterion, const std::vector<SweepResult>& results, const PassCount& all) {
  runner::Check check{.name = criterion.metric,
                      .limit = runner::LimitText({criterion.metric, criterion.min, criterion.max})};
  if (criterion.quantile) {
    check.name += fmt::format(" at {:g}", *criterion.quantile);
    if (const runner::MetricInfo* const info = runner::FindMetric(criterion.metric)) check.unit = info->unit;
  }
  const bool by_interval = criterion.by == JudgedBy::kInterval;
  if (by_interval) check.limit += ", by interval";
  const std::optional<util::Interval> statistic = StatisticOf(criterion, results, all);
  if (statistic) {
    const bool is_open =
        (criterion.min && std::isinf(statistic->low)) || (criterion.max && std::isinf(statistic->high));
    if (by_interval && is_open)
      check.limit += fmt::format(", needs at least {} seeds", util::FewestForQuantile(*criterion.quantile));
    check.value = statistic->value;
    check.pass = (!criterion.min || (by_interval ? statistic->low : statistic->value) >= *criterion.min) &&
                 (!criterion.max || (by_interval ? statistic->high : statistic->value) <= *criterion.max);
  }
  return {check, statistic};
}

/// Decision of the sequential test over the flights in the order of the plan; undecided if flights are missing.
SweepCheck StopDecision(const StopWhen& stop, const SweepOutcome& sweep) {
  SequentialTest test(stop);
  if (sweep.results.size() == sweep.planned) {
    for (const SweepResult& result : sweep.results) test.Add(result.row.passed());
  }
  constexpr std::array<const char*, 3> kWords = {"undecided", "good", "bad"};
  return {{.name = "stop_when",
           .text = kWords[static_cast<std::size_t>(test.decision())],
           .limit = fmt::format("pass rate {:g} rather than {:g}", stop.good_pass_rate, stop.bad_pass_rate),
           .pass = test.decision() == SequentialTest::Decision::kGood},
          {}};
}

std::vector<PassTrial> TrialsOver(std::size_t axis, const std::vector<SweepResult>& results,
                                  const std::string& variant) {
  std::vector<PassTrial> trials;
  for (const SweepResult& result : results) {
    if (result.variant != variant) continue;
    trials.push_back({*AsNumber(result.values[axis]), result.seed, result.row.passed()});
  }
  return trials;
}

std::map<double, PassCount> CountsOf(const std::vector<PassTrial>& trials) {
  std::map<double, PassCount> counts;
  for (const PassTrial& trial : trials) counts[trial.value].Add(trial.seed, trial.passed);
  return counts;
}

util::Interval PosteriorBoundary(PassBoundary posterior, const std::map<double, PassCount>& counts) {
  for (const auto& [value, count] : counts) posterior.Add(value, count.passed, count.flown - count.passed);
  return posterior.boundary();
}

PassBoundaryOf BoundaryOfSearch(const SearchedBoundary& search, std::size_t axis,
                                const std::vector<SweepResult>& results) {
  PassBoundaryOf found{.key = search.key, .pass_rate = search.pass_rate};
  const PassCount all = CountWhere(results, [](const SweepResult&) { return true; });
  if (all.passed == 0 || all.passed == all.flown) return found;
  found.boundary =
      PosteriorBoundary({search.min, search.max, search.pass_rate}, CountsOf(TrialsOver(axis, results, "")));
  found.may_lie_beyond = found.boundary->low == search.min || found.boundary->high == search.max;
  return found;
}

std::vector<PassBoundaryOf> BoundariesOf(const SweepSpec& spec, const std::vector<SweepResult>& results) {
  std::vector<PassBoundaryOf> boundaries;
  for (std::size_t axis = 0; axis < spec.axes.size(); ++axis) {
    const std::string& key = spec.axes[axis].key;
    if (spec.search && spec.search->key == key) boundaries.push_back(BoundaryOfSearch(*spec.search, axis, results));
    if (spec.search || !IsNumeric(spec.axes[axis])) continue;
    for (const std::string& variant : spec.flown_variants()) {
      const auto boundary = PassBoundaryOver(TrialsOver(axis, results, variant));
      if (boundary)
        boundaries.push_back({.variant = variant, .key = key, .pass_rate = kBoundaryPassRate, .boundary = *boundary});
    }
  }
  return boundaries;
}

/// Smallest and largest of the added values.
struct ValueRange {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  void Add(double value) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
};

}  // namespace

std::string ValueText(const runner::Check& check) {
  if (!check.text.empty()) return check.text;
  return check.value ? fmt::format("{:.4g}", *check.value) : "none";
}

bool SweepSummary::meets_criteria() const {
  return std::all_of(criteria.begin(), criteria.end(), [](const SweepCheck& each) { return each.check.pass; });
}

bool SweepSummary::finds_boundary() const {
  return std::any_of(boundaries.begin(), boundaries.end(),
                     [](const PassBoundaryOf& each) { return each.boundary.has_value(); });
}

std::optional<util::Interval> PassBoundaryOver(const std::vector<PassTrial>& trials) {
  const std::map<double, PassCount> counts = CountsOf(trials);
  ValueRange passing, failing;
  for (const auto& [value, count] : counts) {
    if (count.rate().low > kBoundaryPassRate) passing.Add(value);
    if (count.rate().high < kBoundaryPassRate) failing.Add(value);
  }
  const bool are_both = passing.least <= passing.largest && failing.least <= failing.largest;
  if (!are_both || (passing.largest > failing.least && failing.largest > passing.least)) return std::nullopt;
  return PosteriorBoundary({counts.begin()->first, counts.rbegin()->first, kBoundaryPassRate}, counts);
}

bool IsNumeric(const SweepAxis& axis) {
  return axis.listed.size() >= 2 &&
         std::all_of(axis.listed.begin(), axis.listed.end(), [](const std::string& v) { return AsNumber(v); });
}

int CountEnds(const std::vector<SweepResult>& results, ProcessEnd end) {
  return static_cast<int>(std::count_if(results.begin(), results.end(),
                                        [end](const SweepResult& result) { return result.row.process == end; }));
}

std::string FailedProcesses(const std::vector<SweepResult>& results) {
  std::vector<std::string> words;
  for (const ProcessEnd end : {ProcessEnd::kCrashed, ProcessEnd::kHung, ProcessEnd::kOutOfMemory}) {
    const int count = CountEnds(results, end);
    if (count > 0) words.push_back(fmt::format("{} {}", count, util::Words(std::string(Name(end)))));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric) {
  std::vector<double> values;
  for (const SweepResult& result : results) {
    const auto found = result.row.metrics.find(metric);
    if (found != result.row.metrics.end()) values.push_back(found->second);
  }
  return values;
}

SweepOutcome ReadOutcome(const SweepStore& store) {
  return {.spec = store.spec(),
          .results = store.Results(),
          .planned = store.planned(),
          .total = store.total(),
          .stale = store.stale(),
          .unplanned = store.unplanned()};
}

SweepSummary Summarize(const SweepOutcome& sweep) {
  SweepSummary summary{.all = CountWhere(sweep.results, [](const SweepResult&) { return true; }),
                       .by_value = CountsByValue(sweep.spec, sweep.results),
                       .boundaries = BoundariesOf(sweep.spec, sweep.results),
                       .criteria = {},
                       .is_complete = sweep.results.size() == sweep.total};
  if (sweep.spec.stop_when) summary.criteria.push_back(StopDecision(*sweep.spec.stop_when, sweep));
  for (const SweepCriterion& criterion : sweep.spec.criteria) {
    summary.criteria.push_back(Judged(criterion, sweep.results, summary.all));
  }
  return summary;
}

}  // namespace touchdown::sweeper
