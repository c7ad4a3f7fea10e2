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

/// A flight's value of a drawn parameter, and what became of it.
struct DrawnPoint {
  double value = 0.0;
  std::uint64_t seed = 0;
  bool passed = false;
};

std::vector<DrawnPoint> DrawnPoints(const SweepOutcome& sweep, std::size_t axis) {
  std::vector<DrawnPoint> points;
  for (const SweepResult& result : sweep.results) {
    if (const auto value = AsNumber(result.values[axis])) points.push_back({*value, result.seed, result.row.passed()});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const DrawnPoint& a, const DrawnPoint& b) { return a.value < b.value; });
  return points;
}

/// The rows or columns of a heat map.
struct HeatAxis {
  std::vector<std::function<bool(const std::string& value)>> cells = {};
  std::vector<std::string> tics = {};  ///< Labels and positions, for gnuplot; the center of the first cell is 0.
};

/// A cell for each listed value, named; numbers with the smallest first.
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

/// Cells of the same width that hold all values that were drawn, with numbers at their edges.
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
  return sweep.terms.axes[axis].listed.empty() ? DrawnCells(sweep, axis) : ListedCells(sweep.terms.axes[axis]);
}

/// Each group's rate in a line, at its mean value. `points` are sorted.
std::string GroupLines(const std::vector<DrawnPoint>& points) {
  constexpr std::size_t kGroups = 5, kFewest = 5 * kGroups;
  if (points.size() < kFewest) return "";
  std::string csv;
  for (std::size_t group = 0; group < kGroups; ++group) {
    const std::size_t from = group * points.size() / kGroups, to = (group + 1) * points.size() / kGroups;
    PassCount count;
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i) {
      count.Take(points[i].seed, points[i].passed);
      sum += points[i].value;
    }
    const util::Interval rate = count.rate();
    csv += util::CsvLine({Number(sum / count.flown), "", "", util::Fixed(kPercent * rate.value, 2),
                          util::Fixed(kPercent * rate.low, 2), util::Fixed(kPercent * rate.high, 2)});
  }
  return csv;
}

/// Results of the variant at an index.
const char* ColorOf(std::size_t variant) {
  constexpr std::array<const char*, 6> kColors = {"ESTIMATE", "SET_POINT", "THIRD", "FOURTH", "FIRST", "SECOND"};
  return kColors[variant % kColors.size()];
}

/// A dashed line at each edge, in the color of its variant, and its interval shaded.
std::string BoundaryCommands(const SweepSpec& terms, const std::vector<PassBoundaryOf>& edges) {
  const std::vector<std::string> variants = terms.flown_variants();
  std::string commands;
  for (const PassBoundaryOf& each : edges) {
    if (!each.edge) continue;
    const auto variant = std::find(variants.begin(), variants.end(), each.variant) - variants.begin();
    const char* const color = ColorOf(static_cast<std::size_t>(variant));
    commands += fmt::format(
        "set object rectangle from {},graph 0 to {},graph 1 behind fillcolor rgb {} fillstyle transparent solid 0.12 "
        "noborder\nset arrow from {},graph 0 to {},graph 1 nohead dashtype 2 linecolor rgb {}\n",
        Number(each.edge->low), Number(each.edge->high), color, Number(each.edge->value), Number(each.edge->value),
        color);
  }
  return commands;
}

std::string BoundaryCaption(const std::vector<PassBoundaryOf>& edges) {
  const bool is_drawn =
      std::any_of(edges.begin(), edges.end(), [](const PassBoundaryOf& e) { return e.edge.has_value(); });
  return is_drawn ? fmt::format(" Dashed: where the rate goes through {:.4g} %, its 95 % interval shaded.",
                                kPercent * edges.front().pass_rate)
                  : "";
}

}  // namespace

report::Figure PassRateFigure(const SweepOutcome& sweep, std::size_t axis, const std::vector<PassBoundaryOf>& edges) {
  const SweepAxis& over = sweep.terms.axes[axis];
  const std::vector<std::string> variants = sweep.terms.flown_variants();
  std::vector<std::string> values = over.listed;
  std::sort(values.begin(), values.end(),
            [](const std::string& a, const std::string& b) { return AsNumber(a) < AsNumber(b); });
  const double least = *AsNumber(values.front()), most = *AsNumber(values.back());
  report::Figure figure{
      .name = NameOf("pass_rate", over.key),
      .title = over.key,
      .caption = "Share of flights that passed, with its 95 % interval (Wilson)." + BoundaryCaption(edges),
      .csv = "curve,variant,place,value,percent,low,high\n",
      .plot = RangeAround("xrange", least, most) + BoundaryCommands(sweep.terms, edges) +
              fmt::format("set xlabel {} noenhanced\nset ylabel 'passed, %'\nset yrange [-3:103]\n", Quoted(over.key))};
  std::vector<std::string> curves;
  for (std::size_t variant = 0; variant < variants.size(); ++variant) {
    // A little beside one another, so that the intervals of all variants are seen.
    const double beside = 0.008 * (most - least) * (static_cast<double>(variant) - 0.5 * (variants.size() - 1.0));
    for (const std::string& value : values) {
      const PassCount count = CountWhere(sweep.results, [&](const SweepResult& result) {
        return result.variant == variants[variant] && result.values[axis] == value;
      });
      if (count.flown == 0) continue;
      const util::Interval rate = count.rate();
      figure.csv += util::CsvLine({std::to_string(variant), variants[variant], Number(*AsNumber(value) + beside), value,
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
  const SweepAxis &x = sweep.terms.axes[axis_x], &y = sweep.terms.axes[axis_y];
  const HeatAxis across = HeatAxisOf(sweep, axis_x), up = HeatAxisOf(sweep, axis_y);
  const auto &columns = across.cells, &rows = up.cells;
  report::Figure figure{.name = NameOf("heat_map_" + x.key, y.key) + (variant.empty() ? "" : NameOf("", variant)),
                        .title = fmt::format("{} and {}{}", x.key, y.key, variant.empty() ? "" : ", " + variant),
                        .caption = "Share of flights that passed; in each cell how many of how many. Gray: none flown.",
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
  // Pale, so that the same dark figures can be read in every cell of both themes.
  figure.plot =
      fmt::format(
          "set xtics ({})\nset ytics ({})\nset xlabel {} noenhanced\nset ylabel {} noenhanced\nset xrange "
          "[-0.5:{}]\nset yrange [-0.5:{}]\n",
          fmt::join(across.tics, ", "), fmt::join(up.tics, ", "), Quoted(x.key), Quoted(y.key),
          static_cast<double>(columns.size()) - 0.5, static_cast<double>(rows.size()) - 0.5) +
      "set object rectangle from graph 0,graph 0 to graph 1,graph 1 behind fillcolor rgb GRID fillstyle solid "
      "noborder\n"
      "unset key\nunset grid\nset cbrange [0:100]\nset cblabel 'passed, %' textcolor rgb INK\n"
      "set palette defined (0 '#f0a878', 50 '#f4f1ec', 100 '#86bfe8')\nset style fill solid 1.0\n"
      "plot data using 'x':'y':(column('x')-0.49):(column('x')+0.49):(column('y')-0.49):(column('y')+0.49):'percent' "
      "with boxxyerror lc palette";
  constexpr std::size_t kMostWithText = 14;
  if (columns.size() <= kMostWithText) {
    figure.plot +=
        ", '' using 'x':'y':(sprintf('%d/%d', column('passed'), column('flown'))) with labels tc rgb '#111111'";
  }
  figure.plot += "\n";
  figure.width_cm = 12.0;
  figure.height_cm = std::clamp(3.0 + 0.9 * static_cast<double>(rows.size()), 5.0, 14.0);
  return figure;
}

report::Figure DrawnValuesFigure(const SweepOutcome& sweep, std::size_t axis,
                                 const std::vector<PassBoundaryOf>& edges) {
  const std::string& key = sweep.terms.axes[axis].key;
  const std::vector<DrawnPoint> points = DrawnPoints(sweep, axis);
  const std::string groups = GroupLines(points);
  report::Figure figure{
      .name = NameOf("drawn", key),
      .title = key,
      .caption = "Each flight that passed above, each that did not below, spread in height to be seen.",
      .csv = "value,passed,failed,percent,low,high\n"};
  if (!groups.empty()) figure.caption += " The line: share that passed in five groups of as many, with 95 % intervals.";
  figure.caption += BoundaryCaption(edges);
  constexpr double kGoldenRatio = 0.6180339887498949, kSpread = 12.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double spread = kSpread * std::fmod(kGoldenRatio * static_cast<double>(i), 1.0);
    figure.csv += util::CsvLine({Number(points[i].value), points[i].passed ? util::Fixed(104.0 + spread, 2) : "",
                                 points[i].passed ? "" : util::Fixed(-4.0 - spread, 2), "", "", ""});
  }
  figure.csv += groups;
  figure.plot =
      (points.empty() ? "set xrange [0:1]\n" : RangeAround("xrange", points.front().value, points.back().value)) +
      BoundaryCommands(sweep.terms, edges) +
      fmt::format(
          "set xlabel {} noenhanced\nset yrange [-20:120]\n{}\n"
          "set key outside top center horizontal\nplot data using 'value':'passed' with {} title 'passed', '' using "
          "'value':'failed' with {} title 'not passed'",
          Quoted(key), groups.empty() ? "unset ytics" : "set ylabel 'passed, %'\nset ytics 0,25,100", kPassedPoints,
          kFailedPoints);
  if (!groups.empty())
    figure.plot += ", '' using 'value':'percent':'low':'high' with yerrorlines pt 7 ps 0.4 lc rgb INK title 'share'";
  figure.plot += "\n";
  figure.width_cm = 12.0;
  return figure;
}

}  // namespace touchdown::sweeper
