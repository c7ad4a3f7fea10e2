#include "scenarios/paper/outdoor.h"

#include "scenarios/paper/flight_figures.h"
#include "scenarios/paper/flown_flight.h"
#include "scenarios/paper/published.h"
#include "scenarios/paper/table_one.h"
#include "scenarios/paper/text.h"
#include "scenarios/study/statistics.h"

namespace touchdown::scenarios {
namespace {

constexpr double kWorseThanIndoors = 1.5;  // "Similar overall performance".

std::string IdOf(int seed) { return fmt::format("outdoor_{}", seed); }

std::vector<double> Values(const Measured& measured, const std::vector<std::string>& ids, const std::string& key) {
  std::vector<double> values;
  for (const std::string& id : ids) {
    const Json& errors = measured.at(id).at("truth");
    if (errors.contains(key)) values.push_back(errors.at(key).get<double>());
  }
  return values;
}

ReportSection Report(const PaperPlan& plan, const Measured& measured) {
  std::vector<std::string> ids;
  int landed = 0, false_pads = 0;
  double availability = 1.0;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    ids.push_back(IdOf(seed));
    const Json& flight = measured.at(ids.back());
    landed += flight.at("as_expected").get<bool>() ? 1 : 0;
    false_pads += static_cast<int>(flight.value("estimate.false_pads", 0.0));
    availability = std::min(availability, flight.value("estimate.availability", 0.0));
  }
  ReportSection section{.id = "outdoor", .title = "Outdoor flight (Sec. VI-C, Fig. 11)"};
  section.paragraphs.push_back(fmt::format(
      "Takeoff, hover and landing on grass with a path and objects beside the pad, in the sun, which casts shadows of "
      "them and of the vehicle, and on ground that is not level. The pose is relative to the pad. {} of {} flights "
      "landed; "
      "the pad was found in a share of at least {} of the frames that show it whole; {} frames showed a false one.",
      landed, plan.seeds, Fixed(availability, 3), false_pads));
  ReportTable table{.name = "outdoor",
                    .caption = "RMSE against the truth, mean over the seeds.",
                    .head = {"RMSE", "indoors", "outdoors", "ratio"},
                    .rows = {}};
  for (const TableOneRow& row : kTableOne) {
    const double indoors = Mean(Values(measured, AutonomousFlightIds(plan), row.key));
    const std::vector<double> values = Values(measured, ids, row.key);
    const double outdoors = Mean(values);
    const int digits = row.unit == std::string("mm") ? 1 : 2;
    table.rows.push_back({fmt::format("{}, {}", row.label, row.unit), Fixed(indoors, digits), Fixed(outdoors, digits),
                          Fixed(outdoors / indoors, 2)});
    section.compared.push_back(
        {.quantity = fmt::format("Outdoors over indoors, {} RMSE", row.label),
         .unit = "",
         .published = kWorseThanIndoors,
         .ours = outdoors / indoors,
         .spread = fmt::format("{} {} to {} {}", Fixed(indoors, digits), row.unit, Fixed(outdoors, digits), row.unit),
         .why = "The paper says 'similar overall performance'; 1.5 is our reading of it."});
  }
  section.tables.push_back(std::move(table));
  section.figures = FlightFigures("fig_11", "Fig. 11: outdoor flight", measured.at(IdOf(1)).at("series"));
  return section;
}

}  // namespace

Experiment OutdoorExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kFlight_s = 28.0;
  Experiment experiment;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    Scenario scenario = ShippedFlight("outdoor", static_cast<std::uint64_t>(seed));
    vehicle.Equip(scenario);
    experiment.measurements.push_back(
        {.id = IdOf(seed), .expected_s = kFlight_s, .take = [scenario, seed](const StopRequested& stop_requested) {
           return FlyAndSumUp(scenario, {.series = seed == 1}, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return Report(plan, measured); };
  return experiment;
}

}  // namespace touchdown::scenarios
