#include "scenarios/experiments/outdoor.h"

#include <algorithm>
#include <array>

#include "scenarios/experiments/flight_figures.h"
#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/report/published.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr double kWorseThanIndoors = 1.5;  // "Similar overall performance".

std::string OutdoorId(int seed) { return fmt::format("outdoor_{}", seed); }

/// The outdoor flight with one condition removed.
struct Variant {
  const char* id;
  const char* name;
  void (*change)(runner::Scenario&);
};

constexpr std::array<Variant, 2> kVariants = {
    {{"level", "outdoors on level ground", [](runner::Scenario& s) { s.world.ground_tilt = {}; }},
     {"overcast", "outdoors without sun and shadows", [](runner::Scenario& s) { s.scene.sun.to_sky = 0.0; }}}};

std::string OutdoorId(const Variant& variant, int seed) { return fmt::format("outdoor_{}_{}", variant.id, seed); }

std::vector<std::string> Ids(int seeds) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= seeds; ++seed) ids.push_back(OutdoorId(seed));
  return ids;
}

/// Table of the errors indoors, outdoors, and outdoors with one condition removed.
report::ReportTable Variants(const PaperPlan& plan, const Measured& measured) {
  std::vector<std::string> indoors = AutonomousFlightIds(plan);
  indoors.resize(static_cast<std::size_t>(plan.outdoor_variant_seeds));
  const FlightGroup outdoors(measured, Ids(plan.outdoor_variant_seeds));
  report::ReportTable table{
      .name = "outdoor_variants",
      .caption = "Flights with one condition removed, for the first seeds. RMSE relative to the truth.",
      .head = ErrorHead("flight"),
      .rows = {FlightGroup(measured, indoors).ErrorRow("indoors", "truth"), outdoors.ErrorRow("outdoors", "truth")}};
  for (const Variant& variant : kVariants) {
    std::vector<std::string> ids;
    for (int seed = 1; seed <= plan.outdoor_variant_seeds; ++seed) ids.push_back(OutdoorId(variant, seed));
    table.rows.push_back(FlightGroup(measured, ids).ErrorRow(variant.name, "truth"));
  }
  return table;
}

ComparedQuantity RatioOf(const report::TableOneRow& row, const std::optional<double>& indoors,
                         const std::optional<double>& outdoors, int digits) {
  return {
      .quantity = fmt::format("Outdoors over indoors, {} RMSE", row.label),
      .unit = "",
      .published = kWorseThanIndoors,
      .ours = indoors && outdoors ? std::optional(*outdoors / *indoors) : std::nullopt,
      .spread = fmt::format("{} {} to {} {}", util::FixedOrNone(indoors, digits), row.unit,
                            util::FixedOrNone(outdoors, digits), row.unit),
      .why = row.key == "yaw_deg"
                 ? "At rest the estimator treats the sloped ground as level, so the vehicle drifts during the blind "
                   "climb. The view of the pad is then oblique, and the ellipse of the H is not rectified. The second "
                   "table has flights without the slope."
                 : "The paper states 'similar overall performance'; the ratio of 1.5 is our interpretation."};
}

PaperSection ReportOutdoor(const PaperPlan& plan, const Measured& measured) {
  const FlightGroup flights(measured, Ids(plan.seeds)), flights_indoors(measured, AutonomousFlightIds(plan));
  PaperSection section{{.id = "outdoor", .title = "Outdoor flight (Sec. VI-C, Fig. 11)"}};
  const std::vector<double> availability = flights.Values("estimate.availability");
  section.paragraphs.push_back(fmt::format(
      "Takeoff, hover and landing on grass with a path and objects near the pad, on ground that is not level, and in "
      "sunlight with shadows of the objects and of the vehicle. The pose is relative to the pad. {} of {} flights "
      "landed. The minimum availability of the flights is {}: the fraction of the frames with the whole ring in view "
      "in which the pad was found. {} frames had a false detection.",
      flights.ended_as_expected(), flights.count(),
      availability.empty() ? "none" : util::Fixed(*std::min_element(availability.begin(), availability.end()), 3),
      flights.false_pads()));
  report::ReportTable table{.name = "outdoor",
                            .caption = "RMSE relative to the truth, mean over the seeds.",
                            .head = {"RMSE", "indoors", "outdoors", "ratio"}};
  for (const report::TableOneRow& row : report::kTableOne) {
    const std::string key(row.key);
    const std::optional<double> indoors = flights_indoors.MeanError("truth", key),
                                outdoors = flights.MeanError("truth", key);
    const int digits = row.unit == "mm" ? 1 : 2;
    section.compared.push_back(RatioOf(row, indoors, outdoors, digits));
    table.rows.push_back({fmt::format("{}, {}", row.label, row.unit), util::FixedOrNone(indoors, digits),
                          util::FixedOrNone(outdoors, digits), util::FixedOrNone(section.compared.back().ours, 2)});
  }
  section.compared.push_back(flights.Failures("Outdoors"));
  section.tables.push_back(std::move(table));
  if (plan.outdoor_variant_seeds > 0) section.tables.push_back(Variants(plan, measured));
  section.figures = FlightFigures("fig_11", "Fig. 11: outdoor flight", measured.at(OutdoorId(1)).at("series"));
  return section;
}

}  // namespace

Experiment OutdoorExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kFlight_s = 28.0;
  Experiment experiment;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    runner::Scenario scenario = ShippedFlight("outdoor", static_cast<std::uint64_t>(seed));
    vehicle.ApplyTo(scenario);
    experiment.measurements.push_back({.id = OutdoorId(seed),
                                       .expected_s = kFlight_s,
                                       .measure = [scenario, seed](const util::StopRequested& stop_requested) {
                                         return FlyAndSummarize(scenario, {.series = seed == 1}, stop_requested);
                                       }});
  }
  for (const Variant& variant : kVariants) {
    for (int seed = 1; seed <= plan.outdoor_variant_seeds; ++seed) {
      runner::Scenario scenario = ShippedFlight("outdoor", static_cast<std::uint64_t>(seed));
      vehicle.ApplyTo(scenario);
      variant.change(scenario);
      experiment.measurements.push_back({.id = OutdoorId(variant, seed),
                                         .expected_s = kFlight_s,
                                         .measure = [scenario](const util::StopRequested& stop_requested) {
                                           return FlyAndSummarize(scenario, {}, stop_requested);
                                         }});
    }
  }
  experiment.report = [plan](const Measured& measured) { return ReportOutdoor(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
