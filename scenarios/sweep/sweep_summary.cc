#include "scenarios/sweep/sweep_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchdown::scenarios {
namespace {

std::vector<PassCountOf> CountsByValue(const SweepTerms& terms, const std::vector<SweepResult>& results) {
  std::vector<PassCountOf> counts;
  const auto add = [&](const std::string& key, const std::string& value, const auto& belongs) {
    const PassCount count = CountWhere(results, belongs);
    if (count.flown > 0) counts.push_back({key, value, count});
  };
  for (const std::string& variant : terms.variants) {
    add("variant", variant, [&](const SweepResult& result) { return result.variant == variant; });
  }
  for (std::size_t i = 0; i < terms.axes.size(); ++i) {
    for (const std::string& value : terms.axes[i].listed) {
      add(terms.axes[i].key, value, [&](const SweepResult& result) { return result.values[i] == value; });
    }
  }
  return counts;
}

Check Judged(const SweepCriterion& criterion, const std::vector<SweepResult>& results, const PassCount& all) {
  Check check{.name = criterion.metric, .limit = LimitText({criterion.metric, criterion.min, criterion.max})};
  if (criterion.quantile) {
    check.name += fmt::format(" at {:g}", *criterion.quantile);
    if (const MetricInfo* const info = FindMetric(criterion.metric)) check.unit = info->unit;
    const std::vector<double> values = MetricValues(results, criterion.metric);
    if (!values.empty()) check.value = Quantile(values, *criterion.quantile);
  } else if (all.flown > 0) {
    check.value = all.rate().value;
  }
  check.pass = check.value && (!criterion.min || *check.value >= *criterion.min) &&
               (!criterion.max || *check.value <= *criterion.max);
  return check;
}

}  // namespace

bool SweepSummary::keeps_criteria() const {
  return std::all_of(criteria.begin(), criteria.end(), [](const Check& check) { return check.pass; });
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
  return {.terms = store.terms(), .results = store.Results(), .planned = store.planned(), .stale = store.stale()};
}

SweepSummary Summarize(const SweepOutcome& sweep) {
  SweepSummary summary{.all = CountWhere(sweep.results, [](const SweepResult&) { return true; }),
                       .by_value = CountsByValue(sweep.terms, sweep.results),
                       .criteria = {}};
  for (const SweepCriterion& criterion : sweep.terms.criteria) {
    summary.criteria.push_back(Judged(criterion, sweep.results, summary.all));
  }
  return summary;
}

}  // namespace touchdown::scenarios
