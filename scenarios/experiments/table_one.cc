#include "scenarios/experiments/table_one.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "scenarios/experiments/flight_figures.h"
#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flown_flight.h"
#include "scenarios/report/published.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

/// A column of the table.
struct Case {
  const char* name;
  const char* flight;
  const char* id;
  const char* figure;
  double expected_s;  ///< Of a core, for a flight of full length.
};

constexpr std::array<Case, 3> kCases = {{{"hand-held", "hand_held", "hand_held", "fig_6", 75.0},
                                         {"hovering", "disturbed_hover", "hovering", "fig_7", 110.0},
                                         {"autonomous", "takeoff_hover_land", "autonomous", "fig_8", 22.0}}};

std::string TableOneId(const Case& which, int seed) { return fmt::format("{}_{}", which.id, seed); }

runner::Scenario FlightOf(const Case& which, const PaperPlan& plan, const PaperVehicle& vehicle, int seed) {
  std::vector<std::string> set;
  if (which.flight == std::string("hand_held")) set.push_back(fmt::format("hand.duration_s={}", plan.hand_s));
  if (which.flight == std::string("disturbed_hover"))
    set.push_back(fmt::format("script.1.duration_s={}", plan.hover_s));
  runner::Scenario scenario = ShippedFlight(which.flight, static_cast<std::uint64_t>(seed), set);
  vehicle.Equip(scenario);
  return scenario;
}

FlightGroup Flights(const Measured& measured, const PaperPlan& plan, const Case& which) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.seeds; ++seed) ids.push_back(TableOneId(which, seed));
  return {measured, ids};
}

int Digits(const report::TableOneRow& row) { return row.unit == "mm" ? 1 : 2; }

std::string WithSpread(const std::vector<double>& values, int digits) {
  if (values.empty()) return "none";
  return fmt::format("{} ± {}", util::Fixed(util::Mean(values), digits),
                     util::Fixed(util::StandardDeviation(values), digits));
}

const char* WhyOf(const report::TableOneRow& row, std::size_t column) {
  if (row.key == "yaw_deg") {
    return column == 0
               ? "The H's ellipse is not rectified: the more the view is tilted, the further off, as in the paper."
               : "Tilts are small, and the unrectified H is nearly the true one.";
  }
  if (row.key == "z_mm") {
    return "Against the truth; the paper's own reference is good to a few millimeters.";
  }
  return "Sub-pixel contour points; whole pixels give the figures of the table below.";
}

std::vector<ComparedQuantity> Compared(const PaperPlan& plan, const Measured& measured) {
  std::vector<ComparedQuantity> compared;
  for (std::size_t column = 0; column < kCases.size(); ++column) {
    const FlightGroup flights = Flights(measured, plan, kCases[column]);
    for (const report::TableOneRow& row : report::kTableOne) {
      const std::vector<double> errors = flights.Errors("truth", std::string(row.key));
      const std::string worst =
          errors.empty() ? "none" : util::Fixed(*std::max_element(errors.begin(), errors.end()), Digits(row));
      compared.push_back({.quantity = fmt::format("Table I, {}, {} RMSE", kCases[column].name, row.label),
                          .unit = std::string(row.unit),
                          .published = row.published[column],
                          .ours = flights.MeanError("truth", std::string(row.key)),
                          .spread = fmt::format("worst of {} seeds {}", plan.seeds, worst),
                          .why = WhyOf(row, column)});
    }
    compared.push_back(flights.Failures(fmt::format("Table I, {}", kCases[column].name)));
  }
  return compared;
}

report::ReportTable Table(const PaperPlan& plan, const Measured& measured, const std::string& name,
                          const std::string& caption, const std::string& against) {
  report::ReportTable table{.name = name, .caption = caption, .head = {"RMSE"}};
  for (const Case& which : kCases) {
    table.head.push_back(fmt::format("{}, paper", which.name));
    table.head.push_back("ours");
  }
  for (const report::TableOneRow& row : report::kTableOne) {
    std::vector<std::string> cells{fmt::format("{}, {}", row.label, row.unit)};
    for (std::size_t column = 0; column < kCases.size(); ++column) {
      cells.push_back(util::Fixed(row.published[column], 1));
      const FlightGroup flights = Flights(measured, plan, kCases[column]);
      cells.push_back(WithSpread(flights.Errors(against, std::string(row.key)), Digits(row)));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// "0.98 to 1".
std::string Span(const std::vector<double>& values, int digits) {
  if (values.empty()) return "none";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} to {}", util::Fixed(*low, digits), util::Fixed(*high, digits));
}

std::string Conditions(const FlightGroup& flights, const char* name) {
  return fmt::format(
      "<b>{}</b>: {} of {} flights ended as they should; the pad was found in a share of {} of the frames that show it "
      "whole, and {} frames showed one where there was none; largest tilt {}°, height up to {} m.",
      name, flights.ended_as_expected(), flights.count(), Span(flights.Values("estimate.availability"), 3),
      flights.false_pads(), Span(flights.Values("flight.max_tilt_deg"), 1), Span(flights.Values("max_height_m"), 2));
}

PaperSection ReportTableOne(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{
      {.id = "table-one", .title = "Hand-held, hovering, autonomous flight (Sec. VI-B.1-3, Figs. 6-8, Table I)"}};
  section.paragraphs.push_back(
      "Vision's unfiltered pose of the body, over the frames with status ok, on the rendered camera with lens, noise, "
      "blur and latency, in rooms full of decoys; estimator and autopilot know camera and mountings as the "
      "calibrations above found them. The first estimate must be near (0, 0, 300 mm) and level, where the paper "
      "starts. Mean over the seeds ± standard deviation.");
  for (const Case& which : kCases) {
    section.paragraphs.push_back(Conditions(Flights(measured, plan, which), which.name));
  }
  section.tables.push_back(
      Table(plan, measured, "table_1_truth", "Table I against the truth, sub-pixel contour points.", "truth"));
  section.tables.push_back(Table(plan, measured, "table_1_tracking",
                                 "The same against the simulated tracking system, whose noise, occlusions and outliers "
                                 "are in the figures as they are in the paper's.",
                                 "tracking"));
  section.tables.push_back(Table(plan, measured, "table_1_integer",
                                 "The same flights and frames with contour points on whole pixels, against the truth: "
                                 "the paper does not say which it used.",
                                 "integer"));
  for (const Case& which : kCases) {
    const std::vector<report::Figure> figures =
        FlightFigures(which.figure, fmt::format("Fig. {}: {}", which.figure[4], which.name),
                      measured.at(TableOneId(which, 1)).at("series"));
    section.figures.insert(section.figures.end(), figures.begin(), figures.end());
  }
  section.compared = Compared(plan, measured);
  return section;
}

}  // namespace

Experiment TableOneExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  Experiment experiment;
  for (const Case& which : kCases) {
    for (int seed = 1; seed <= plan.seeds; ++seed) {
      const runner::Scenario scenario = FlightOf(which, plan, vehicle, seed);
      experiment.measurements.push_back({.id = TableOneId(which, seed),
                                         .expected_s = which.expected_s,
                                         .take = [scenario, seed](const util::StopRequested& stop_requested) {
                                           return FlyAndSumUp(scenario, {.integer_contours = true, .series = seed == 1},
                                                              stop_requested);
                                         }});
    }
  }
  experiment.report = [plan](const Measured& measured) { return ReportTableOne(plan, measured); };
  return experiment;
}

std::string TableOneLatex(const PaperPlan& plan, const Measured& measured) {
  std::string text =
      "% Table I of Yang, Scherer and Zell, published and measured: mean over the seeds, against the truth.\n"
      "\\begin{tabular}{lrrrrrr}\n\\hline\n & \\multicolumn{2}{c}{Hand-held} & \\multicolumn{2}{c}{Hovering} & "
      "\\multicolumn{2}{c}{Auto} \\\\\nRMSE & paper & ours & paper & ours & paper & ours \\\\\n\\hline\n";
  for (const report::TableOneRow& row : report::kTableOne) {
    text += fmt::format("{} ({})", row.label, row.unit);
    for (std::size_t column = 0; column < kCases.size(); ++column) {
      const auto ours = Flights(measured, plan, kCases[column]).MeanError("truth", std::string(row.key));
      text += fmt::format(" & {} & {}", util::Fixed(row.published[column], 1), util::FixedOrNone(ours, Digits(row)));
    }
    text += " \\\\\n";
  }
  return text + "\\hline\n\\end{tabular}\n";
}

std::vector<std::string> AutonomousFlightIds(const PaperPlan& plan) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.seeds; ++seed) ids.push_back(TableOneId(kCases[2], seed));
  return ids;
}

}  // namespace touchdown::experiments
