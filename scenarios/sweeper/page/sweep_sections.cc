#include "scenarios/sweeper/page/sweep_sections.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "models/error.h"
#include "scenarios/sweeper/analysis/compare.h"
#include "scenarios/sweeper/page/figure_text.h"
#include "scenarios/sweeper/page/metric_figures.h"
#include "scenarios/sweeper/page/pass_rate_figures.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

constexpr const char* kTouchdownError = "flight.touchdown_xy_error_m";

std::string Short(double value) { return fmt::format("{:.4g}", value); }

bool HasMetric(const SweepOutcome& sweep, const std::string& metric) {
  return std::any_of(sweep.results.begin(), sweep.results.end(),
                     [&](const SweepResult& result) { return result.row.metrics.contains(metric); });
}

/// Interval as text. An infinite bound is a question mark.
std::string IntervalText(const util::Interval& interval) {
  const auto bound = [](double value) { return std::isfinite(value) ? Short(value) : std::string("?"); };
  return fmt::format("{}–{}", bound(interval.low), bound(interval.high));
}

report::ReportSection CriteriaSection(const SweepSummary& summary) {
  report::ReportTable table{.name = "criteria",
                            .caption = "Criteria of the whole sweep.",
                            .head = {"Criterion", "Value", "95 % interval", "Unit", "Limit", "Met"}};
  for (const auto& [check, interval] : summary.criteria) {
    table.rows.push_back({check.name, ValueText(check), interval ? IntervalText(*interval) : "", check.unit,
                          util::WithSigns(check.limit),
                          !summary.is_complete ? "not yet judged"
                          : check.pass         ? "✓ yes"
                                               : "✗ no"});
  }
  report::ReportSection section{.id = "criteria", .title = "Criteria"};
  section.tables.push_back(std::move(table));
  return section;
}

report::ReportTable PassRateTable(const SweepSummary& summary) {
  report::ReportTable table{.name = "pass_rates",
                            .caption =
                                "Pass rates of the flights with the same value, with 95 % confidence intervals. For "
                                "the intervals, all flights of a seed count as one.",
                            .head = {"Parameter", "Value", "Passed, %", "Interval, %", "Passed", "Flown", "Seeds"}};
  const auto add = [&table](const std::string& key, const std::string& value, const PassCount& count) {
    table.rows.push_back({key, value, RateText(count), RateInterval(count), std::to_string(count.passed),
                          std::to_string(count.flown), std::to_string(count.seeds.size())});
  };
  add("all", "", summary.all);
  for (const PassCountOf& each : summary.by_value) add(each.key, each.value, each.count);
  return table;
}

std::vector<PassBoundaryOf> PassBoundariesOver(std::size_t axis, const SweepOutcome& sweep,
                                               const SweepSummary& summary) {
  std::vector<PassBoundaryOf> boundaries;
  std::copy_if(summary.boundaries.begin(), summary.boundaries.end(), std::back_inserter(boundaries),
               [&](const PassBoundaryOf& each) { return each.key == sweep.spec.axes[axis].key; });
  return boundaries;
}

report::ReportTable PassBoundariesTable(const SweepSummary& summary) {
  report::ReportTable table{.name = "edges",
                            .caption =
                                "Values at which the pass rate crosses a level: median and 95 % interval of the "
                                "posterior of a logistic curve.",
                            .head = {"Parameter", "Variant", "Pass rate, %", "Boundary", "Interval"}};
  for (const PassBoundaryOf& each : summary.boundaries) {
    table.rows.push_back(
        {each.key, each.variant, Short(kPercent * each.pass_rate),
         each.boundary ? Short(each.boundary->value) : "none found",
         each.boundary ? IntervalText(*each.boundary) + (each.may_lie_beyond ? ", or beyond" : "") : ""});
  }
  return table;
}

void AddFigureOver(std::size_t axis, const SweepOutcome& sweep, const SweepSummary& summary,
                   report::ReportSection& section) {
  const SweepAxis& over = sweep.spec.axes[axis];
  const std::vector<PassBoundaryOf> boundaries = PassBoundariesOver(axis, sweep, summary);
  if (over.listed.empty()) {
    section.figures.push_back(DrawnValuesFigure(sweep, axis, boundaries));
  } else if (IsNumeric(over)) {
    section.figures.push_back(PassRateFigure(sweep, axis, boundaries));
  }
}

/// Adds figures over single parameters, and over the pairs of the first few.
void AddPassRateFigures(const SweepOutcome& sweep, const SweepSummary& summary, report::ReportSection& section) {
  constexpr std::size_t kMaxSingle = 8, kMaxInPairs = 4;
  const std::size_t axes = sweep.spec.axes.size();
  for (std::size_t axis = 0; axis < std::min(axes, kMaxSingle); ++axis) AddFigureOver(axis, sweep, summary, section);
  for (std::size_t x = 0; x < std::min(axes, kMaxInPairs); ++x) {
    for (std::size_t y = x + 1; y < std::min(axes, kMaxInPairs); ++y) {
      for (const std::string& variant : sweep.spec.flown_variants()) {
        section.figures.push_back(HeatMapFigure(sweep, x, y, variant));
      }
    }
  }
}

report::ReportSection PassRateSection(const SweepOutcome& sweep, const SweepSummary& summary) {
  report::ReportSection section{.id = "pass-rate", .title = "Pass rate"};
  AddPassRateFigures(sweep, summary, section);
  if (!summary.boundaries.empty()) section.tables.push_back(PassBoundariesTable(summary));
  section.tables.push_back(PassRateTable(summary));
  return section;
}

/// Outer radius of the pad of the first flight; nullopt if this program cannot read its scenario.
std::optional<double> PadRadius_m(const SweepOutcome& sweep) {
  try {
    return runner::ParseScenario(sweep.results.front().row.scenario, "scenario", {}).pad.outer_radius_m;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

report::ReportTable MetricsTable(const SweepOutcome& sweep) {
  report::ReportTable table{.name = "metrics",
                            .caption = "Quantiles over the flights that have the metric.",
                            .head = {"Metric", "Unit", "Flights", "5 %", "25 %", "Median", "75 %", "95 %"}};
  for (const runner::MetricInfo& metric : runner::AllMetrics()) {
    const std::vector<double> values = MetricValues(sweep.results, std::string(metric.name));
    if (values.empty()) continue;
    std::vector<std::string> row{std::string(metric.name), std::string(metric.unit), std::to_string(values.size())};
    for (const double q : {0.05, 0.25, 0.5, 0.75, 0.95}) row.push_back(Short(util::Quantile(values, q)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Figures of the metrics in the criteria, and of the touchdown error.
report::ReportSection MetricsSection(const SweepOutcome& sweep) {
  report::ReportSection section{.id = "metrics", .title = "Metrics"};
  std::vector<std::string> shown{kTouchdownError};
  for (const SweepCriterion& criterion : sweep.spec.criteria) {
    if (std::find(shown.begin(), shown.end(), criterion.metric) == shown.end()) shown.push_back(criterion.metric);
  }
  for (const std::string& metric : shown) {
    if (HasMetric(sweep, metric)) section.figures.push_back(HistogramFigure(sweep, metric));
  }
  section.tables.push_back(MetricsTable(sweep));
  return section;
}

report::ReportTable VariantTable(const StoredResults& stored, const std::string& a, const std::string& b) {
  report::ReportTable table{
      .name = "variants",
      .caption =
          "Second variant minus first variant, over the pairs of flights with the same seed and values, with 95 % "
          "intervals, for which all pairs of a seed count as one. Detectable: the smallest difference that these "
          "seeds detect with 80 % power.",
      .head = {"Metric", "Unit", "Pairs", "Seeds", a, b, "Difference", "Interval", "Detectable"}};
  for (const PairedDifference& each : Compare(OfVariant(stored, a), OfVariant(stored, b), {}).differences) {
    table.rows.push_back({each.name, each.unit, std::to_string(each.pairs), std::to_string(each.seeds), Short(each.a),
                          Short(each.b), fmt::format("{:+.4g}", each.difference.value),
                          fmt::format("{:+.4g} … {:+.4g}", each.difference.low, each.difference.high),
                          Short(each.min_detectable_difference)});
  }
  return table;
}

/// Comparisons of the first variant with the others.
report::ReportSection VariantsSection(const SweepOutcome& sweep) {
  report::ReportSection section{.id = "variants", .title = "Variants"};
  const StoredResults stored{.source = sweep.spec.name, .keys = sweep.spec.keys(), .results = sweep.results};
  for (std::size_t i = 1; i < sweep.spec.variants.size(); ++i) {
    try {
      section.tables.push_back(VariantTable(stored, sweep.spec.variants.front(), sweep.spec.variants[i]));
    } catch (const InputError&) {
      continue;  // There are no pairs yet.
    }
  }
  return section;
}

report::ReportSection CausesSection(const SweepOutcome& sweep) {
  std::map<std::string, int> counts;
  for (const SweepResult& result : sweep.results) {
    if (!result.row.passed()) ++counts[CauseOf(result.row)];
  }
  std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  report::ReportTable table{.name = "causes",
                            .caption = "The first check that a flight did not meet, and the phase in which it failed.",
                            .head = {"Cause", "Flights", "Of all, %"}};
  for (const auto& [cause, count] : sorted) {
    const double percent = kPercent * count / static_cast<double>(sweep.results.size());
    table.rows.push_back({cause, std::to_string(count), util::Fixed(percent, 1)});
  }
  report::ReportSection section{.id = "causes", .title = "Causes of failure"};
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

std::string CauseOf(const FlightRow& row) {
  if (row.process != ProcessEnd::kFlown) return util::Words(std::string(Name(row.process)));
  if (row.failed_check.empty()) return std::string(Name(row.verdict));
  const std::string what =
      row.failed_check == "outcome" ? util::Words(std::string(Name(row.outcome))) : row.failed_check;
  return row.failed_phase.empty() ? what : fmt::format("{} in {}", what, util::Words(row.failed_phase));
}

std::string RateText(const PassCount& count) { return util::Fixed(kPercent * count.rate().value, 1); }

std::string RateInterval(const PassCount& count) {
  const util::Interval rate = count.rate();
  return fmt::format("{}–{}", util::Fixed(kPercent * rate.low, 1), util::Fixed(kPercent * rate.high, 1));
}

std::vector<report::ReportSection> SweepSections(const SweepOutcome& sweep, const SweepSummary& summary) {
  std::vector<report::ReportSection> sections;
  if (!summary.criteria.empty()) sections.push_back(CriteriaSection(summary));
  if (sweep.results.empty()) return sections;
  sections.push_back(PassRateSection(sweep, summary));
  if (HasMetric(sweep, "flight.touchdown_x_m")) {
    if (const auto radius = PadRadius_m(sweep)) {
      sections.push_back({.id = "touchdown", .title = "Touchdown", .figures = {TouchdownFigure(sweep, *radius)}});
    }
  }
  sections.push_back(MetricsSection(sweep));
  if (sweep.spec.variants.size() > 1) sections.push_back(VariantsSection(sweep));
  if (summary.all.passed < summary.all.flown) sections.push_back(CausesSection(sweep));
  return sections;
}

}  // namespace touchdown::sweeper
