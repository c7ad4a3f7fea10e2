#include "scenarios/experiments/landings.h"

#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr double kPublishedX_mm = 24.0, kPublishedY_mm = 86.0, kPublishedYaw_deg = 6.0;

std::string LandingId(int landing) { return fmt::format("landing_{}", landing); }

/// A landing from a random pose near the hover at 1 m.
runner::Scenario LandingFrom(const PaperVehicle& vehicle, int landing) {
  const auto seed = static_cast<std::uint64_t>(1000 + landing);
  models::RandomStream random(seed, "paper.landing.start");
  runner::Scenario scenario = ShippedFlight("landing", seed);
  constexpr double kOffset_m = 0.1, kYaw_deg = 5.0;
  scenario.start.position_m = {kOffset_m * random.Normal(), kOffset_m * random.Normal(), 1.0};
  scenario.start.yaw_deg = kYaw_deg * random.Normal();
  vehicle.ApplyTo(scenario);
  return scenario;
}

/// Deviations at rest of the landings that came to rest.
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
      "There is no wind, and the landing gear does not bounce. The blind descent ends at the predicted ground "
      "height; the motors are not switched off high above the ground.";
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
       .why = "Landings that did not end at rest on the landing gear."});
}

std::string RestPositionsCsv(const Deviations& d) {
  std::string csv = "x_mm,y_mm\n";
  for (std::size_t i = 0; i < d.signed_x_mm.size(); ++i) {
    csv += util::CsvLine({util::Fixed(d.signed_x_mm[i], 3), util::Fixed(d.signed_y_mm[i], 3)});
  }
  return csv;
}

PaperSection ReportLandings(const PaperPlan& plan, const Measured& measured) {
  std::vector<std::string> ids;
  for (int i = 1; i <= plan.landings; ++i) ids.push_back(LandingId(i));
  const FlightGroup consecutive(measured, AutonomousFlightIds(plan)), independent(measured, ids);
  const Deviations deviations = DeviationsOf(independent);
  const auto landed = static_cast<int>(deviations.x_mm.size());
  const util::Interval rate = util::WilsonInterval(landed, independent.count());
  PaperSection section{{.id = "landings", .title = "Landings (Sec. VI-B.3)"}};
  section.paragraphs.push_back(fmt::format(
      "The landings in a row are the {} autonomous flights above. In addition, {} independent landings start near the "
      "hover at 1 m, with an offset of 0.1 m along X and Y and 5° in yaw (1 sigma), each in its own room. {} of them "
      "came to rest on the landing gear (95 %: {} to {} %). The deviations are those of the vehicle at rest from the "
      "center and the heading of the pad.",
      consecutive.count(), independent.count(), landed, util::Fixed(100.0 * rate.low, 1),
      util::Fixed(100.0 * rate.high, 1)));
  Compare(fmt::format("{} landings in a row", consecutive.count()), consecutive, section);
  Compare(fmt::format("{} landings", independent.count()), independent, section);
  section.figures.push_back(
      {.name = "landing_places",
       .title = "Rest positions of the vehicle",
       .caption = fmt::format("{} landings. Circle: outer edge of the ring, with a radius of 90 mm. Dashed box: mean "
                              "deviations in the paper.",
                              independent.count()),
       .csv = RestPositionsCsv(deviations),
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
         .measure = [scenario = LandingFrom(vehicle, i)](const util::StopRequested& stop_requested) {
           return FlyAndSummarize(scenario, {}, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportLandings(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
