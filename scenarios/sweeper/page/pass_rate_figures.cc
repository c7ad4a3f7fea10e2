#include "scenarios/sweeper/page/pass_rate_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "scenarios/sweeper/page/figure_text.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

/// Outcome of a flight at a drawn value of a parameter.
struct DrawnPoint {
  double value = 0.0;
  std::uint64_t seed = 0;
  bool passed = false;
};

/// Flights with a drawn value on an axis, sorted by value.
std::vector<DrawnPoint> DrawnPoints(const SweepOutcome& sweep, std::size_t axis) {
  std::vector<DrawnPoint> points;
  for (const SweepResult& result : sweep.results) {
    if (const auto value = AsNumber(result.values[axis])) points.push_back({*value, result.seed, result.row.passed()});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const DrawnPoint& a, const DrawnPoint& b) { return a.value < b.value; });
  return points;
}

/// Rows or columns of a heat map.
struct HeatAxis {
  std::vector<std::function<bool(const std::string& value)>> cells = {};  ///< Whether a value is in a cell.
  std::vector<std::string> tics = {};  ///< Labels and positions for gnuplot; the center of the first cell is at 0.
};

/// One cell for each listed value. Numbers are sorted.
HeatAxis ListedCells(const SweepAxis& axis) {
  std::vector<std::string> values = axis.listed;
  if (IsNumeric(axis)) {
    std::sort(values.begin(), values.end(),
              [](const std::string& a, const std::string& b) { return AsNumber(a) < AsNumber(b); });
  }
  constexpr std::size_t kMostTics = 14;
  const std::size_t step = (values.size() + kMostTics - 1) / kMostTics;
  HeatAxis heat;
  for (std::size_t i = 0; i < values.size(); ++i) {
    heat.cells.push_back([value = values[i]](const std::string& other) { return other == value; });
    if (i % step == 0) heat.tics.push_back(fmt::format("{} {}", Quoted(values[i]), i));
  }
  return heat;
}

/// Cells of equal width over the range of the drawn values, with numbers at their borders.
HeatAxis DrawnCells(const SweepOutcome& sweep, std::size_t axis) {
  constexpr int kCells = 5;
  const std::vector<DrawnPoint> points = DrawnPoints(sweep, axis);
  if (points.empty()) return {};
  const double least = points.front().value, span = points.back().value - least;
  const auto cell_of = [=](double value) {
    return span > 0.0 ? std::min(static_cast<int>(kCells * (value - least) / span), kCells - 1) : 0;
  };
  HeatAxis heat;
  for (int i = 0; i < kCells; ++i) {
    heat.cells.push_back([=](const std::string& value) { return cell_of(AsNumber(value).value_or(least)) == i; });
  }
  for (int i = 0; i <= kCells; ++i) {
    heat.tics.push_back(fmt::format("'{:.2g}' {}", least + i * span / kCells, i - 0.5));
  }
  return heat;
}

HeatAxis HeatAxisOf(const SweepOutcome& sweep, std::size_t axis) {
  return sweep.spec.axes[axis].listed.empty() ? DrawnCells(sweep, axis) : ListedCells(sweep.spec.axes[axis]);
}

/// CSV lines with the pass rates of groups of equal size, at their mean values; empty for too few points. `points` are
/// sorted by value.
std::string GroupLines(const std::vector<DrawnPoint>& points) {
  constexpr std::size_t kGroups = 5, kFewest = 5 * kGroups;
  if (points.size() < kFewest) return "";
  std::string csv;
  for (std::size_t group = 0; group < kGroups; ++group) {
    const std::size_t from = group * points.size() / kGroups, to = (group + 1) * points.size() / kGroups;
    PassCount count;
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i) {
      count.Add(points[i].seed, points[i].passed);
      sum += points[i].value;
    }
    const util::Interval rate = count.rate();
    csv += util::CsvLine({Number(sum / count.flown), "", "", util::Fixed(kPercent * rate.value, 2),
                          util::Fixed(kPercent * rate.low, 2), util::Fixed(kPercent * rate.high, 2)});
  }
  return csv;
}

/// Color of the curve of a variant.
const char* ColorOf(std::size_t variant) {
  constexpr std::array<const char*, 6> kColors = {"ESTIMATE", "SET_POINT", "THIRD", "FOURTH", "FIRST", "SECOND"};
  return kColors[variant % kColors.size()];
}

/// Gnuplot commands for a dashed line at each boundary and its shaded interval, in the color of the variant.
std::string BoundaryCommands(const SweepSpec& spec, const std::vector<PassBoundaryOf>& boundaries) {
  const std::vector<std::string> variants = spec.flown_variants();
  std::string commands;
  for (const PassBoundaryOf& each : boundaries) {
    if (!each.boundary) continue;
    const auto variant = std::find(variants.begin(), variants.end(), each.variant) - variants.begin();
    const char* const color = ColorOf(static_cast<std::size_t>(variant));
    commands += fmt::format(
        "set object rectangle from {},graph 0 to {},graph 1 behind fillcolor rgb {} fillstyle transparent solid 0.12 "
        "noborder\nset arrow from {},graph 0 to {},graph 1 nohead dashtype 2 linecolor rgb {}\n",
        Number(each.boundary->low), Number(each.boundary->high), color, Number(each.boundary->value),
        Number(each.boundary->value), color);
  }
  return commands;
}

std::string BoundaryCaption(const std::vector<PassBoundaryOf>& boundaries) {
  const bool is_drawn = std::any_of(boundaries.begin(), boundaries.end(),
                                    [](const PassBoundaryOf& each) { return each.boundary.has_value(); });
  return is_drawn ? fmt::format(" Dashed: boundary at a pass rate of {:.4g} %; shaded: its 95 % interval.",
                                kPercent * boundaries.front().pass_rate)
                  : "";
}

}  // namespace

report::Figure PassRateFigure(const SweepOutcome& sweep, std::size_t axis,
                              const std::vector<PassBoundaryOf>& boundaries) {
  const SweepAxis& over = sweep.spec.axes[axis];
  const std::vector<std::string> variants = sweep.spec.flown_variants();
  std::vector<std::string> values = over.listed;
  std::sort(values.begin(), values.end(),
            [](const std::string& a, const std::string& b) { return AsNumber(a) < AsNumber(b); });
  const double least = *AsNumber(values.front()), most = *AsNumber(values.back());
  report::Figure figure{
      .name = FigureName("pass_rate", over.key),
      .title = over.key,
      .caption = "Fraction of flights that passed, with 95 % intervals (Wilson)." + BoundaryCaption(boundaries),
      .csv = "curve,variant,place,value,percent,low,high\n",
      .plot = RangeCommand("xrange", least, most) + BoundaryCommands(sweep.spec, boundaries) +
              fmt::format("set xlabel {} noenhanced\nset ylabel 'passed, %'\nset yrange [-3:103]\n", Quoted(over.key))};
  std::vector<std::string> curves;
  for (std::size_t variant = 0; variant < variants.size(); ++variant) {
    // Small horizontal offsets separate the intervals of the variants.
    const double offset = 0.008 * (most - least) * (static_cast<double>(variant) - 0.5 * (variants.size() - 1.0));
    for (const std::string& value : values) {
      const PassCount count = CountWhere(sweep.results, [&](const SweepResult& result) {
        return result.variant == variants[variant] && result.values[axis] == value;
      });
      if (count.flown == 0) continue;
      const util::Interval rate = count.rate();
      figure.csv += util::CsvLine({std::to_string(variant), variants[variant], Number(*AsNumber(value) + offset), value,
                                   util::Fixed(kPercent * rate.value, 2), util::Fixed(kPercent * rate.low, 2),
                                   util::Fixed(kPercent * rate.high, 2)});
    }
    curves.push_back(
        fmt::format("data using (column('curve') == {} ? column('place') : NaN):'percent':'low':'high' with "
                    "yerrorlines pt 7 ps 0.5 "
                    "lw 1.4 lc rgb {} title {}",
                    variant, ColorOf(variant), Quoted(variants[variant])));
  }
  figure.plot += variants.size() > 1 ? "set key outside top center horizontal noenhanced\n" : "unset key\n";
  figure.plot += fmt::format("plot {}\n", fmt::join(curves, ", "));
  figure.width_cm = 12.0;
  figure.height_cm = 6.0;
  return figure;
}

report::Figure HeatMapFigure(const SweepOutcome& sweep, std::size_t axis_x, std::size_t axis_y,
                             const std::string& variant) {
  const SweepAxis &x = sweep.spec.axes[axis_x], &y = sweep.spec.axes[axis_y];
  const HeatAxis x_axis = HeatAxisOf(sweep, axis_x), y_axis = HeatAxisOf(sweep, axis_y);
  const auto &columns = x_axis.cells, &rows = y_axis.cells;
  report::Figure figure{
      .name = FigureName("heat_map_" + x.key, y.key) + (variant.empty() ? "" : FigureName("", variant)),
      .title = fmt::format("{} and {}{}", x.key, y.key, variant.empty() ? "" : ", " + variant),
      .caption = "Fraction of flights that passed. Each cell shows passed/flown flights. Gray: no flights.",
      .csv = "x,y,passed,flown,percent\n"};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const PassCount count = CountWhere(sweep.results, [&](const SweepResult& result) {
        return result.variant == variant && columns[column](result.values[axis_x]) && rows[row](result.values[axis_y]);
      });
      if (count.flown == 0) continue;
      figure.csv += fmt::format("{},{},{},{},{}\n", column, row, count.passed, count.flown,
                                util::Fixed(kPercent * count.rate().value, 2));
    }
  }
  // Pale colors, so that dark numbers are readable in all cells of both themes.
  figure.plot =
      fmt::format(
          "set xtics ({})\nset ytics ({})\nset xlabel {} noenhanced\nset ylabel {} noenhanced\nset xrange "
          "[-0.5:{}]\nset yrange [-0.5:{}]\n",
          fmt::join(x_axis.tics, ", "), fmt::join(y_axis.tics, ", "), Quoted(x.key), Quoted(y.key),
          static_cast<double>(columns.size()) - 0.5, static_cast<double>(rows.size()) - 0.5) +
      "set object rectangle from graph 0,graph 0 to graph 1,graph 1 behind fillcolor rgb GRID fillstyle solid "
      "noborder\n"
      "unset key\nunset grid\nset cbrange [0:100]\nset cblabel 'passed, %' textcolor rgb INK\n"
      "set palette defined (0 '#f0a878', 50 '#f4f1ec', 100 '#86bfe8')\nset style fill solid 1.0\n"
      "plot data using 'x':'y':(column('x')-0.49):(column('x')+0.49):(column('y')-0.49):(column('y')+0.49):'percent' "
      "with boxxyerror lc palette";
  constexpr std::size_t kMaxWithText = 14;
  if (columns.size() <= kMaxWithText) {
    figure.plot +=
        ", '' using 'x':'y':(sprintf('%d/%d', column('passed'), column('flown'))) with labels tc rgb '#111111'";
  }
  figure.plot += "\n";
  figure.width_cm = 12.0;
  figure.height_cm = std::clamp(3.0 + 0.9 * static_cast<double>(rows.size()), 5.0, 14.0);
  return figure;
}

report::Figure DrawnValuesFigure(const SweepOutcome& sweep, std::size_t axis,
                                 const std::vector<PassBoundaryOf>& boundaries) {
  const std::string& key = sweep.spec.axes[axis].key;
  const std::vector<DrawnPoint> points = DrawnPoints(sweep, axis);
  const std::string groups = GroupLines(points);
  report::Figure figure{
      .name = FigureName("drawn", key),
      .title = key,
      .caption = "Passed flights are above, failed flights below. Their vertical position has no meaning.",
      .csv = "value,passed,failed,percent,low,high\n"};
  if (!groups.empty())
    figure.caption += " Line: fraction that passed in five groups of equal size, with 95 % intervals.";
  figure.caption += BoundaryCaption(boundaries);
  constexpr double kGoldenRatio = 0.6180339887498949, kSpread = 12.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double spread = kSpread * std::fmod(kGoldenRatio * static_cast<double>(i), 1.0);
    figure.csv += util::CsvLine({Number(points[i].value), points[i].passed ? util::Fixed(104.0 + spread, 2) : "",
                                 points[i].passed ? "" : util::Fixed(-4.0 - spread, 2), "", "", ""});
  }
  figure.csv += groups;
  figure.plot =
      (points.empty() ? "set xrange [0:1]\n" : RangeCommand("xrange", points.front().value, points.back().value)) +
      BoundaryCommands(sweep.spec, boundaries) +
      fmt::format(
          "set xlabel {} noenhanced\nset yrange [-20:120]\n{}\n"
          "set key outside top center horizontal\nplot data using 'value':'passed' with {} title 'passed', '' using "
          "'value':'failed' with {} title 'not passed'",
          Quoted(key), groups.empty() ? "unset ytics" : "set ylabel 'passed, %'\nset ytics 0,25,100", kPassedPoints,
          kFailedPoints);
  if (!groups.empty())
    figure.plot += ", '' using 'value':'percent':'low':'high' with yerrorlines pt 7 ps 0.4 lc rgb INK title 'fraction'";
  figure.plot += "\n";
  figure.width_cm = 12.0;
  return figure;
}

}  // namespace touchdown::sweeper
