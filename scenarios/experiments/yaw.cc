#include "scenarios/experiments/yaw.h"

#include <array>
#include <optional>

#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flown_flight.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/experiments/yaw_study.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr std::array<double, 3> kHeights_m = {0.32, 0.6, 1.0};  // The H is 100, 53 and 32 px high.
constexpr double kPublishedEllipse_deg = 3.0, kPublishedMoments_deg = 1.0;

constexpr std::array<const char*, kYawMethodNames.size()> kMethodWords = {
    "ellipse of the H, whole pixels",         "ellipse of the H, sub-pixel",
    "moments of the H, binary image",         "moments of the H, gray image",
    "ellipse of the rectangle, whole pixels", "ellipse of the rectangle, sub-pixel"};

std::string TurnedId(double height_m) { return fmt::format("yaw_{:.0f}_cm", 100.0 * height_m); }
std::string FlownId(int seed) { return fmt::format("rectangle_{}", seed); }

Json MeasureTurned(double height_m) {
  Json rows = Json::array();
  for (const YawErrors& errors : StudyYaw(height_m)) {
    Json row = Json::array({errors.yaw_deg});
    for (const double error_deg : errors.error_deg) row.push_back(error_deg);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<YawErrors> RowsOf(const Json& json) {
  std::vector<YawErrors> rows;
  for (const Json& row : json) {
    YawErrors errors{.yaw_deg = row.at(0).get<int>()};
    for (std::size_t i = 0; i < errors.error_deg.size(); ++i) errors.error_deg[i] = row.at(i + 1).get<double>();
    rows.push_back(errors);
  }
  return rows;
}

std::string RowsCsv(const std::vector<YawErrors>& rows) {
  std::string csv = "yaw_deg";
  for (const std::string_view name : kYawMethodNames) csv += fmt::format(",{}_deg", name);
  csv += "\n";
  for (const YawErrors& row : rows) {
    std::vector<std::string> cells{std::to_string(row.yaw_deg)};
    for (const double error_deg : row.error_deg) cells.push_back(util::Fixed(error_deg, 5));
    csv += util::CsvLine(cells);
  }
  return csv;
}

void ReportTurned(const Measured& measured, PaperSection& section) {
  report::ReportTable table{
      .name = "yaw_methods",
      .caption = "Largest and RMS error over a whole turn in steps of one degree, by the height of the H in the image.",
      .head = {"method"}};
  constexpr double kHOverHeight_px = 32.0;  // 0.1 m at 320 px of focal length, at 1 m.
  for (const double height_m : kHeights_m) {
    table.head.push_back(fmt::format("{:.0f} px: largest, deg", kHOverHeight_px / height_m));
    table.head.push_back("RMS, deg");
  }
  for (std::size_t method = 0; method < kYawMethodNames.size(); ++method) {
    table.rows.push_back({kMethodWords[method]});
    for (const double height_m : kHeights_m) {
      const ErrorSize size = SizeOfErrors(RowsOf(measured.at(TurnedId(height_m))), static_cast<YawMethod>(method));
      table.rows.back().push_back(util::Fixed(size.largest_deg, 3));
      table.rows.back().push_back(util::Fixed(size.rms_deg, 3));
    }
  }
  section.tables.push_back(std::move(table));
  const std::vector<YawErrors> rows = RowsOf(measured.at(TurnedId(kHeights_m[0])));
  section.figures.push_back(
      {.name = "yaw_errors",
       .title = "Error of the yaw from a turned H",
       .caption = "H and rectangle 100 px high; the ellipse by sub-pixel contour points.",
       .csv = RowsCsv(rows),
       .plot = "set key top right horizontal\nset xlabel 'yaw, deg'\nset ylabel 'error, deg'\nset xrange [0:180]\n"
               "plot data using 'yaw_deg':'ellipse_of_h_subpixel_deg' with lines lw 1.3 lc rgb ESTIMATE title 'ellipse "
               "of H', \\\n"
               "     data using 'yaw_deg':'moments_of_h_grey_deg' with lines lw 1.3 lc rgb SECOND title 'moments of "
               "H', \\\n"
               "     data using 'yaw_deg':'ellipse_of_rectangle_subpixel_deg' with lines lw 1.3 lc rgb SET_POINT title "
               "'ellipse of rectangle'\n"});
  const auto largest = [&](YawMethod method) { return SizeOfErrors(rows, method).largest_deg; };
  const double h_deg = largest(YawMethod::kEllipseOfHSubpixel);
  section.compared.push_back(
      {.quantity = "Yaw of a turned H by its ellipse, largest error",
       .unit = "deg",
       .published = kPublishedEllipse_deg,
       .ours = h_deg,
       .spread = fmt::format("whole pixels {}", util::Fixed(largest(YawMethod::kEllipseOfHInteger), 3)),
       .why = "A larger, sharper synthetic H with its contour at sub-pixel places."});
  section.compared.push_back(
      {.quantity = "Yaw of a turned H by image moments, largest error",
       .unit = "deg",
       .published = kPublishedMoments_deg,
       .ours = largest(YawMethod::kMomentsOfHGrey),
       .spread = fmt::format("of the binary image {}", util::Fixed(largest(YawMethod::kMomentsOfHBinary), 3)),
       .why = "All pixels count, and gray ones by how dark they are."});
  section.compared.push_back(
      {.quantity = "Yaw of a turned rectangle by its ellipse, largest error",
       .unit = "deg",
       .published = h_deg,
       .ours = largest(YawMethod::kEllipseOfRectangleSubpixel),
       .spread = fmt::format("whole pixels {}", util::Fixed(largest(YawMethod::kEllipseOfRectangleInteger), 3)),
       .why = "'Even smaller errors' than the H's: the bound is our H's own."});
}

void ReportFlown(const PaperPlan& plan, const Measured& measured, PaperSection& section) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.seeds; ++seed) ids.push_back(FlownId(seed));
  const FlightGroup over_rectangle(measured, ids), over_h(measured, AutonomousFlightIds(plan));
  section.paragraphs.push_back(fmt::format(
      "A pad with a solid rectangle as large as the H in its place, the network retrained on it (<code>touchdown train "
      "--letter rectangle</code>): {} of {} flights took off, hovered and landed; {} frames showed a false pad.",
      over_rectangle.ended_as_expected(), over_rectangle.count(), over_rectangle.false_pads()));
  section.tables.push_back(
      {.name = "rectangle_flights",
       .caption = "The autonomous flight over both pads, RMSE against the truth, mean over the seeds.",
       .head = ErrorHead("letter"),
       .rows = {over_h.ErrorRow("H", "truth"), over_rectangle.ErrorRow("rectangle", "truth")}});
  section.compared.push_back(over_rectangle.Failures("Pad with a rectangle"));
}

PaperSection ReportYaw(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "yaw", .title = "Yaw from the letter (Sec. IV-C.3)"}};
  section.paragraphs.push_back(
      "A synthetic H, turned in steps of one degree, seen from straight above without noise: the error of the major "
      "axis of the ellipse fitted to its contour, as the estimator does it, of image moments, and of the ellipse on a "
      "solid rectangle of the same size.");
  ReportTurned(measured, section);
  ReportFlown(plan, measured, section);
  return section;
}

}  // namespace

Experiment YawExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kTurn_s = 3.0, kFlight_s = 22.0;
  Experiment experiment;
  for (const double height_m : kHeights_m) {
    experiment.measurements.push_back(
        {.id = TurnedId(height_m), .expected_s = kTurn_s, .take = [height_m](const util::StopRequested&) {
           return MeasureTurned(height_m);
         }});
  }
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    runner::Scenario scenario = ShippedFlight("rectangle_pad", static_cast<std::uint64_t>(seed));
    vehicle.Equip(scenario);
    experiment.measurements.push_back(
        {.id = FlownId(seed), .expected_s = kFlight_s, .take = [scenario](const util::StopRequested& stop_requested) {
           return FlyAndSumUp(scenario, {}, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportYaw(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
