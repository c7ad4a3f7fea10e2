#include "scenarios/sweeper/page/metric_figures.h"

#include <algorithm>
#include <cmath>

#include "scenarios/sweeper/page/figure_text.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

/// Bin of a histogram, with its numbers of passed and of all flights.
struct Bin {
  double from = 0.0, to = 0.0;
  int passed = 0, all = 0;
};

/// Histogram with bins of equal width over the range of the metric.
std::vector<Bin> BinsOf(const std::vector<SweepResult>& results, const std::string& metric) {
  const std::vector<double> values = MetricValues(results, metric);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const bool is_one = *least == *most;
  constexpr double kWidthOfOne = 0.1;
  const double span = !is_one ? *most - *least : *least == 0.0 ? kWidthOfOne : kWidthOfOne * std::abs(*least);
  const double low = is_one ? *least - 0.5 * span : *least;
  const auto count = is_one ? 1 : std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(values.size())), 5, 40);
  std::vector<Bin> bins(count);
  const double width = span / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    bins[i].from = low + width * static_cast<double>(i);
    bins[i].to = bins[i].from + width;
  }
  for (const SweepResult& result : results) {
    const auto found = result.row.metrics.find(metric);
    if (found == result.row.metrics.end()) continue;
    Bin& bin = bins[std::min(count - 1, static_cast<std::size_t>((found->second - low) / width))];
    ++bin.all;
    bin.passed += result.row.passed() ? 1 : 0;
  }
  return bins;
}

/// Limits of the criteria on the metric, without those that are far from all values.
std::vector<double> LimitsNear(const std::vector<Bin>& bins, const SweepSpec& spec, const std::string& metric) {
  const double span = bins.back().to - bins.front().from;
  std::vector<double> limits;
  for (const SweepCriterion& criterion : spec.criteria) {
    if (criterion.metric != metric) continue;
    for (const std::optional<double>& limit : {criterion.min, criterion.max}) {
      if (limit && *limit > bins.front().from - span && *limit < bins.back().to + span) limits.push_back(*limit);
    }
  }
  return limits;
}

/// Gnuplot commands for the range of a histogram and for its limits.
std::string LimitCommands(const std::vector<Bin>& bins, const std::vector<double>& limits) {
  double least = bins.front().from, most = bins.back().to;
  std::string commands;
  for (const double limit : limits) {
    least = std::min(least, limit);
    most = std::max(most, limit);
    commands += fmt::format("set arrow from {0},graph 0 to {0},graph 1 nohead dt 2 lw 1.4 lc rgb INK front\n", limit);
  }
  return commands + RangeCommand("xrange", least, most);
}

}  // namespace

report::Figure HistogramFigure(const SweepOutcome& sweep, const std::string& metric) {
  const std::vector<Bin> bins = BinsOf(sweep.results, metric);
  const std::vector<double> limits = LimitsNear(bins, sweep.spec, metric);
  const runner::MetricInfo* const info = runner::FindMetric(metric);
  const std::string unit = info == nullptr || info->unit.empty() ? "" : fmt::format(", {}", info->unit);
  report::Figure figure{.name = FigureName("histogram", metric),
                        .title = metric,
                        .caption = fmt::format("Histogram over the {} flights that have this metric.",
                                               MetricValues(sweep.results, metric).size()),
                        .csv = "from,to,passed,all\n"};
  if (!limits.empty()) figure.caption += " Dashed: limit of a criterion on a quantile.";
  for (const Bin& bin : bins)
    figure.csv += fmt::format("{},{},{},{}\n", Number(bin.from), Number(bin.to), bin.passed, bin.all);
  figure.plot =
      LimitCommands(bins, limits) +
      fmt::format(
          "set xlabel {} noenhanced\nset ylabel 'flights'\nset yrange [0:*]\nset key outside top center horizontal "
          "top\nset style fill border rgb PAPER\n"
          "plot data using 'from':(0):'from':'to':(0):'passed' with boxxyerror lc rgb ESTIMATE title "
          "'passed', '' using 'from':(0):'from':'to':'passed':'all' with boxxyerror lc rgb SET_POINT "
          "title 'not passed'\n",
          Quoted(metric + unit));
  figure.width_cm = 12.0;
  figure.height_cm = 6.0;
  return figure;
}

report::Figure TouchdownFigure(const SweepOutcome& sweep, double pad_radius_m) {
  report::Figure figure{.name = "touchdown", .title = "Touchdown positions", .csv = "x_mm,passed_y_mm,failed_y_mm\n"};
  double reach_mm = kMillimeters * pad_radius_m;
  int count = 0;
  for (const SweepResult& result : sweep.results) {
    const runner::Metrics& metrics = result.row.metrics;
    const auto x = metrics.find("flight.touchdown_x_m"), y = metrics.find("flight.touchdown_y_m");
    if (x == metrics.end() || y == metrics.end()) continue;
    const double x_mm = kMillimeters * x->second, y_mm = kMillimeters * y->second;
    reach_mm = std::max({reach_mm, std::abs(x_mm), std::abs(y_mm)});
    const std::string y_text = util::Fixed(y_mm, 3);
    const bool passed = result.row.passed();
    figure.csv += util::CsvLine({util::Fixed(x_mm, 3), passed ? y_text : "", passed ? "" : y_text});
    ++count;
  }
  const std::string radius = Number(kMillimeters * pad_radius_m), reach = Number(1.1 * reach_mm);
  figure.caption = fmt::format(
      "Position of the body origin relative to the pad at the first contact, for the {} flights that touched down. The "
      "circle is the ring of the pad with a radius of {} mm.",
      count, radius);
  figure.plot = fmt::format(
      "set size ratio -1\nset xlabel 'x, mm'\nset ylabel 'y, mm'\nset xrange [-{0}:{0}]\nset yrange [-{0}:{0}]\n"
      "set key outside top center horizontal\nset samples 181\n"
      "plot sample [t=0:2.1*pi] '+' using ({1}*cos(t)):({1}*sin(t)) with lines lc rgb MUTED lw 1.4 title 'ring', "
      "data using 'x_mm':'passed_y_mm' with {2} title 'passed', '' using 'x_mm':'failed_y_mm' with {3} title 'not "
      "passed'\n",
      reach, radius, kPassedPoints, kFailedPoints);
  figure.width_cm = 12.0;
  figure.height_cm = 10.0;
  return figure;
}

}  // namespace touchdown::sweeper
