#include "scenarios/sweep/sweep_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchdown::scenarios {
namespace {

PassCount CountWhere(const std::vector<SweepResult>& results, const auto& belongs) {
  PassCount count;
  for (const SweepResult& result : results) {
    if (!belongs(result)) continue;
    ++count.flown;
    count.passed += result.row.passed() ? 1 : 0;
  }
  return count;
}

std::vector<PassCountOf> CountsByValue(const SweepFile& file, const std::vector<SweepResult>& results) {
  std::vector<PassCountOf> counts;
  const auto add = [&](const std::string& key, const std::string& value, const auto& belongs) {
    const PassCount count = CountWhere(results, belongs);
    if (count.flown > 0) counts.push_back({key, value, count});
  };
  for (const SweepVariant& variant : file.variants) {
    if (variant.name.empty()) continue;
    add("variant", variant.name, [&](const SweepResult& result) { return result.variant == variant.name; });
  }
  for (std::size_t i = 0; i < file.parameters.size(); ++i) {
    const auto* listed = std::get_if<ListedValues>(&file.parameters[i].values);
    if (listed == nullptr) continue;
    for (const std::string& value : listed->yaml) {
      add(file.parameters[i].key, value, [&](const SweepResult& result) { return result.values[i] == value; });
    }
  }
  return counts;
}

Check Judged(const SweepCriterion& criterion, const std::vector<SweepResult>& results, const PassCount& all) {
  Check check{.name = criterion.metric, .limit = LimitText({criterion.metric, criterion.min, criterion.max})};
  if (criterion.quantile) {
    check.name += fmt::format(" at {:g}", *criterion.quantile);
    check.unit = FindMetric(criterion.metric)->unit;
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

SweepSummary Summarize(const SweepFile& file, const std::vector<SweepResult>& results, std::size_t planned) {
  SweepSummary summary{.planned = static_cast<int>(planned),
                       .all = CountWhere(results, [](const SweepResult&) { return true; }),
                       .by_value = CountsByValue(file, results),
                       .criteria = {}};
  for (const SweepCriterion& criterion : file.criteria) {
    summary.criteria.push_back(Judged(criterion, results, summary.all));
  }
  return summary;
}

}  // namespace touchdown::scenarios
