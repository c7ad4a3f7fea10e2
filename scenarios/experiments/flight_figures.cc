#include "scenarios/experiments/flight_figures.h"

#include <array>

#include "scenarios/util/csv_writer.h"

namespace touchdown::experiments {
namespace {

constexpr std::array<const char*, 3> kSources = {"true", "tracked", "vision"};
constexpr std::array<const char*, 6> kCoordinates = {"x_m", "y_m", "z_m", "roll_deg", "pitch_deg", "yaw_deg"};

std::string SeriesCsv(const Json& series) {
  std::vector<std::string> head{"t_s"};
  for (const char* source : kSources) {
    for (const char* coordinate : kCoordinates) head.push_back(fmt::format("{}_{}", source, coordinate));
  }
  std::string csv = util::CsvLine(head);
  for (const Json& row : series) {
    std::vector<std::string> cells;
    for (const Json& cell : row) cells.push_back(cell.is_null() ? "" : fmt::format("{:.6g}", cell.get<double>()));
    csv += util::CsvLine(cells);
  }
  return csv;
}

/// Plot script with three coordinates in vertically stacked panels, starting at kCoordinates[first].
std::string ThreePanels(std::size_t first) {
  std::string plot = "set multiplot layout 3,1 margins 0.08,0.99,0.09,0.95 spacing 0,0.04\nset format x ''\n";
  for (std::size_t i = first; i < first + 3; ++i) {
    const std::string name = kCoordinates[i];
    const std::string unit = name.substr(name.rfind('_') + 1), label = name.substr(0, name.rfind('_'));
    if (i == first + 2) plot += "set format x '%g'\nset xlabel 't, s' offset 0,0.6\n";
    plot += i == first ? "set key at graph 1,1.16 right top horizontal\n" : "unset key\n";
    plot += fmt::format(
        "set ylabel '{0}, {1}' offset 1.5,0\n"
        "plot data using 't_s':'tracked_{2}' with points pt 7 ps 0.18 lc rgb SECOND title 'tracking system', \\\n"
        "     data using 't_s':'true_{2}' with lines lw 1.0 lc rgb INK title 'truth', \\\n"
        "     data using 't_s':'vision_{2}' with points pt 7 ps 0.18 lc rgb SET_POINT title 'vision'\n",
        label, unit, name);
  }
  return plot + "unset multiplot\n";
}

}  // namespace

std::vector<report::Figure> FlightFigures(const std::string& name, const std::string& title, const Json& series) {
  const std::string csv = SeriesCsv(series);
  constexpr double kHeight_cm = 11.0;
  return {{.name = name + "a_position",
           .title = title + ", position",
           .caption = "Vision (orange), tracking system (green, with its outliers and gaps) and truth (line), seed 1.",
           .csv = csv,
           .plot = ThreePanels(0),
           .height_cm = kHeight_cm},
          {.name = name + "b_attitude",
           .title = title + ", attitude",
           .caption = "Roll, pitch and yaw of the same flight.",
           .csv = csv,
           .plot = ThreePanels(3),
           .height_cm = kHeight_cm}};
}

}  // namespace touchdown::experiments
