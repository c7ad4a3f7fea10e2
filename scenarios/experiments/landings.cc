#include "scenarios/experiments/landings.h"

#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flown_flight.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr double kPublishedX_mm = 24.0, kPublishedY_mm = 86.0, kPublishedYaw_deg = 6.0;

std::string LandingId(int landing) { return fmt::format("landing_{}", landing); }

/// From a place drawn about the hover at 1 m.
runner::Scenario LandingFrom(const PaperVehicle& vehicle, int landing) {
  const auto seed = static_cast<std::uint64_t>(1000 + landing);
  models::RandomStream random(seed, "paper.landing.start");
  runner::Scenario scenario = ShippedFlight("landing", seed);
  constexpr double kOff_m = 0.1, kYaw_deg = 5.0;
  scenario.start.position_m = {kOff_m * random.Normal(), kOff_m * random.Normal(), 1.0};
  scenario.start.yaw_deg = kYaw_deg * random.Normal();
  vehicle.Equip(scenario);
  return scenario;
}

/// At rest, of the landings that came to rest.
struct Deviations {
  std::vector<double> x_mm, y_mm, yaw_deg, signed_x_mm, signed_y_mm;
};

Deviations DeviationsOf(const FlightGroup& flights) {
  Deviations all;
  for (const Json& flight : flights.flights()) {
    if (!flight.contains("rest")) continue;
    const Json& rest = flight.at("rest");
    all.signed_x_mm.push_back(rest.at("x_mm").get<double>());
    all.signed_y_mm.push_back(rest.at("y_mm").get<double>());
    all.x_mm.push_back(std::abs(all.signed_x_mm.back()));
    all.y_mm.push_back(std::abs(all.signed_y_mm.back()));
    all.yaw_deg.push_back(std::abs(rest.at("yaw_deg").get<double>()));
  }
  return all;
}

std::string Spread(const util::Interval& interval, int digits) {
  return fmt::format("95 %: {} to {}", util::Fixed(std::max(0.0, interval.low), digits),
                     util::Fixed(interval.high, digits));
}

void Compare(const std::string& which, const FlightGroup& flights, PaperSection& section) {
  const std::string why =
      "No wind, and no landing gear that bounces; the blind descent ends at the ground by prediction, not by cutting "
      "the motors high above it.";
  const auto row = [&](const char* what, const char* unit, double published, const std::vector<double>& values) {
    ComparedQuantity compared{
        .quantity = fmt::format("{}: mean |{}|", which, what), .unit = unit, .published = published, .why = why};
    if (!values.empty()) {
      const util::Interval mean = util::MeanInterval(values);
      compared.ours = mean.value;
      compared.spread = Spread(mean, 2);
    }
    section.compared.push_back(std::move(compared));
  };
  const Deviations d = DeviationsOf(flights);
  row("x", "mm", kPublishedX_mm, d.x_mm);
  row("y", "mm", kPublishedY_mm, d.y_mm);
  row("yaw", "deg", kPublishedYaw_deg, d.yaw_deg);
  section.compared.push_back(
      {.quantity = fmt::format("{}: wrong landings", which),
       .unit = "",
       .published = 0.0,
       .ours = flights.count() - static_cast<int>(d.x_mm.size()),
       .spread = fmt::format("of {}; {} frames with a false pad", flights.count(), flights.false_pads()),
       .why = "A landing that did not end at rest on its gear."});
}

std::string PlacesCsv(const Deviations& d) {
  std::string csv = "x_mm,y_mm\n";
  for (std::size_t i = 0; i < d.signed_x_mm.size(); ++i) {
    csv += util::CsvLine({util::Fixed(d.signed_x_mm[i], 3), util::Fixed(d.signed_y_mm[i], 3)});
  }
  return csv;
}

PaperSection ReportLandings(const PaperPlan& plan, const Measured& measured) {
  std::vector<std::string> ids;
  for (int i = 1; i <= plan.landings; ++i) ids.push_back(LandingId(i));
  const FlightGroup row(measured, AutonomousFlightIds(plan)), many(measured, ids);
  const Deviations places = DeviationsOf(many);
  const auto landed = static_cast<int>(places.x_mm.size());
  const util::Interval share = util::WilsonInterval(landed, many.count());
  PaperSection section{{.id = "landings", .title = "Landings (Sec. VI-B.3)"}};
  section.paragraphs.push_back(fmt::format(
      "In a row: the {} autonomous flights above. Beyond them {} landings from about the hover at 1 m, 0.1 "
      "m (1 sigma, along X and Y) off and 5° turned, each in a room of its own: {} came to rest on their "
      "gear (95 %: {} to {} %). Deviations are of the vehicle at rest, from the pad's center and heading.",
      row.count(), many.count(), landed, util::Fixed(100.0 * share.low, 1), util::Fixed(100.0 * share.high, 1)));
  Compare(fmt::format("{} landings in a row", row.count()), row, section);
  Compare(fmt::format("{} landings", many.count()), many, section);
  section.figures.push_back(
      {.name = "landing_places",
       .title = "Where the vehicle came to rest",
       .caption = fmt::format(
           "{} landings; the ring of the pad is 90 mm in radius, the paper's mean deviations are the dashed box.",
           many.count()),
       .csv = PlacesCsv(places),
       .plot =
           fmt::format("set size ratio -1\nset xlabel 'x, mm'\nset ylabel 'y, mm'\nset xrange [-100:100]\n"
                       "set yrange [-100:100]\nunset key\n"
                       "set object 1 rect from -{0},-{1} to {0},{1} fs empty border rgb SET_POINT dt 2 lw 1.2\n"
                       "plot sample [t=0:2.1*pi] '+' using (90*cos(t)):(90*sin(t)) with lines lc rgb MUTED lw 1.4, \\\n"
                       "     data using 'x_mm':'y_mm' with points pt 7 ps 0.35 lc rgb ESTIMATE\n",
                       kPublishedX_mm, kPublishedY_mm),
       .width_cm = 11.0,
       .height_cm = 10.0});
  return section;
}

}  // namespace

Experiment LandingsExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kLanding_s = 9.0;
  Experiment experiment;
  for (int i = 1; i <= plan.landings; ++i) {
    experiment.measurements.push_back(
        {.id = LandingId(i),
         .expected_s = kLanding_s,
         .take = [scenario = LandingFrom(vehicle, i)](const util::StopRequested& stop_requested) {
           return FlyAndSumUp(scenario, {}, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportLandings(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
