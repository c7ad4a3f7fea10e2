#include "scenarios/experiments/table_one.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "scenarios/experiments/flight_figures.h"
#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/report/published.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

/// A pair of columns of Table I, and the flight that it is measured on.
struct Case {
  const char* name;
  const char* flight;
  const char* id;
  const char* figure;
  double expected_s;  ///< Computation time on one core, for a flight of full length.
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
  vehicle.ApplyTo(scenario);
  return scenario;
}

FlightGroup Flights(const Measured& measured, const PaperPlan& plan, const Case& which) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.seeds; ++seed) ids.push_back(TableOneId(which, seed));
  return {measured, ids};
}

int Digits(const report::TableOneRow& row) { return row.unit == "mm" ? 1 : 2; }

std::string MeanWithSpread(const std::vector<double>& values, int digits) {
  if (values.empty()) return "none";
  return fmt::format("{} ± {}", util::Fixed(util::Mean(values), digits),
                     util::Fixed(util::StandardDeviation(values), digits));
}

const char* ExplanationOf(const report::TableOneRow& row, std::size_t column) {
  if (row.key == "yaw_deg") {
    return column == 0
               ? "The ellipse of the H is not rectified, so the error grows with the tilt of the view, as in the paper."
               : "Tilts are small, so the ellipse of the H is nearly undistorted.";
  }
  if (row.key == "z_mm") {
    return "Relative to the truth; the reference of the paper has an accuracy of a few millimeters.";
  }
  return "Sub-pixel contour points; the table below has the values for integer contour points.";
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
                          .why = ExplanationOf(row, column)});
    }
    compared.push_back(flights.Failures(fmt::format("Table I, {}", kCases[column].name)));
  }
  return compared;
}

report::ReportTable Table(const PaperPlan& plan, const Measured& measured, const std::string& name,
                          const std::string& caption, const std::string& reference) {
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
      cells.push_back(MeanWithSpread(flights.Errors(reference, std::string(row.key)), Digits(row)));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Range of the values, for example "0.98 to 1".
std::string RangeText(const std::vector<double>& values, int digits) {
  if (values.empty()) return "none";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} to {}", util::Fixed(*low, digits), util::Fixed(*high, digits));
}

std::string Conditions(const FlightGroup& flights, const char* name) {
  return fmt::format(
      "<b>{}</b>: {} of {} flights ended with the expected outcome. The availability was {} (fraction of the frames "
      "with the whole ring in view in which the pad was found). {} frames had a false detection. The largest tilt "
      "was {}°, and the maximum height was {} m.",
      name, flights.ended_as_expected(), flights.count(), RangeText(flights.Values("estimate.availability"), 3),
      flights.false_pads(), RangeText(flights.Values("flight.max_tilt_deg"), 1),
      RangeText(flights.Values("max_height_m"), 2));
}

/// Availability and false pads with and without the template check, on the same frames.
report::ReportTable VerificationTable(const PaperPlan& plan, const Measured& measured) {
  report::ReportTable table{
      .name = "table_1_verification",
      .caption = "Detection with and without the template check (estimator.paper.verify), on the same frames.",
      .head = {"flights", "availability, template", "availability, none", "false pads, template", "false pads, none"}};
  for (const Case& which : kCases) {
    const FlightGroup flights = Flights(measured, plan, which);
    table.rows.push_back({which.name, RangeText(flights.Values("estimate.availability"), 3),
                          RangeText(flights.Errors("unverified", "estimate.availability"), 3),
                          RangeText(flights.Values("estimate.false_pads"), 0),
                          RangeText(flights.Errors("unverified", "estimate.false_pads"), 0)});
  }
  return table;
}

PaperSection ReportTableOne(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{
      {.id = "table-one", .title = "Hand-held, hovering, autonomous flight (Sec. VI-B.1-3, Figs. 6-8, Table I)"}};
  section.paragraphs.push_back(
      "Errors of the unfiltered vision pose of the body, over the frames with status ok. The camera is rendered with "
      "lens distortion, noise, blur and latency, in rooms with many distractors. Estimator and autopilot use the "
      "calibrations above. The first estimate must be near (0, 0, 300 mm) and level, where the flights of the paper "
      "start. Values are the mean over the seeds ± the standard deviation.");
  for (const Case& which : kCases) {
    section.paragraphs.push_back(Conditions(Flights(measured, plan, which), which.name));
  }
  section.tables.push_back(
      Table(plan, measured, "table_1_truth", "Table I relative to the truth, with sub-pixel contour points.", "truth"));
  section.tables.push_back(
      Table(plan, measured, "table_1_tracking",
            "Table I relative to the simulated tracking system. As in the paper, the values include "
            "the noise, occlusions and outliers of the tracking system.",
            "tracking"));
  section.tables.push_back(Table(plan, measured, "table_1_integer",
                                 "Table I relative to the truth on the same flights and frames, with integer contour "
                                 "points. The paper does not state which points it uses.",
                                 "integer"));
  section.tables.push_back(Table(plan, measured, "table_1_unverified",
                                 "Table I relative to the truth on the same flights and frames, with verify: none, as "
                                 "published: the geometric constraint is the only check of a candidate.",
                                 "unverified"));
  section.tables.push_back(VerificationTable(plan, measured));
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
      experiment.measurements.push_back(
          {.id = TableOneId(which, seed),
           .expected_s = which.expected_s,
           .measure = [scenario, seed](const util::StopRequested& stop_requested) {
             return FlyAndSummarize(scenario, {.integer_contours = true, .unverified = true, .series = seed == 1},
                                    stop_requested);
           }});
    }
  }
  experiment.report = [plan](const Measured& measured) { return ReportTableOne(plan, measured); };
  return experiment;
}

std::string TableOneLatex(const PaperPlan& plan, const Measured& measured) {
  std::string text =
      "% Table I of Yang, Scherer and Zell, published and measured: mean over the seeds, relative to the truth.\n"
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
