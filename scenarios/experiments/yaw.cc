#include "scenarios/experiments/yaw.h"

#include <array>
#include <optional>

#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/experiments/yaw_study.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr std::array<double, 3> kHeights_m = {0.32, 0.6, 1.0};  // The H is 100, 53 and 32 px high.
constexpr double kPublishedEllipse_deg = 3.0, kPublishedMoments_deg = 1.0;

constexpr std::array<const char*, kYawMethodNames.size()> kMethodLabels = {
    "ellipse of the H, whole pixels",         "ellipse of the H, sub-pixel",
    "moments of the H, binary image",         "moments of the H, gray image",
    "ellipse of the rectangle, whole pixels", "ellipse of the rectangle, sub-pixel"};

std::string RotatedHId(double height_m) { return fmt::format("yaw_{:.0f}_cm", 100.0 * height_m); }
std::string RectangleFlightId(int seed) { return fmt::format("rectangle_{}", seed); }

Json MeasureRotatedH(double height_m) {
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

void ReportRotatedH(const Measured& measured, PaperSection& section) {
  report::ReportTable table{
      .name = "yaw_methods",
      .caption = "Largest and RMS error over 360° in steps of one degree, by the height of the H in the image.",
      .head = {"method"}};
  // Height of the H of 0.1 m in the image, at 1 m with a focal length of 320 px.
  constexpr double kHOverHeight_px = 32.0;
  for (const double height_m : kHeights_m) {
    table.head.push_back(fmt::format("{:.0f} px: largest, deg", kHOverHeight_px / height_m));
    table.head.push_back("RMS, deg");
  }
  for (std::size_t method = 0; method < kYawMethodNames.size(); ++method) {
    table.rows.push_back({kMethodLabels[method]});
    for (const double height_m : kHeights_m) {
      const ErrorSummary errors =
          SummarizeErrors(RowsOf(measured.at(RotatedHId(height_m))), static_cast<YawMethod>(method));
      table.rows.back().push_back(util::Fixed(errors.largest_deg, 3));
      table.rows.back().push_back(util::Fixed(errors.rms_deg, 3));
    }
  }
  section.tables.push_back(std::move(table));
  const std::vector<YawErrors> rows = RowsOf(measured.at(RotatedHId(kHeights_m[0])));
  section.figures.push_back(
      {.name = "yaw_errors",
       .title = "Yaw error from a rotated H",
       .caption = "H and rectangle are 100 px high. The ellipses are fitted to sub-pixel contour points.",
       .csv = RowsCsv(rows),
       .plot = "set key top right horizontal\nset xlabel 'yaw, deg'\nset ylabel 'error, deg'\nset xrange [0:180]\n"
               "plot data using 'yaw_deg':'ellipse_of_h_subpixel_deg' with lines lw 1.3 lc rgb ESTIMATE title 'ellipse "
               "of H', \\\n"
               "     data using 'yaw_deg':'moments_of_h_grey_deg' with lines lw 1.3 lc rgb SECOND title 'moments of "
               "H', \\\n"
               "     data using 'yaw_deg':'ellipse_of_rectangle_subpixel_deg' with lines lw 1.3 lc rgb SET_POINT title "
               "'ellipse of rectangle'\n"});
  const auto largest = [&](YawMethod method) { return SummarizeErrors(rows, method).largest_deg; };
  const double h_deg = largest(YawMethod::kEllipseOfHSubpixel);
  section.compared.push_back(
      {.quantity = "Yaw of a turned H by its ellipse, largest error",
       .unit = "deg",
       .published = kPublishedEllipse_deg,
       .ours = h_deg,
       .spread = fmt::format("whole pixels {}", util::Fixed(largest(YawMethod::kEllipseOfHInteger), 3)),
       .why = "The synthetic H is larger and sharper, and its contour has sub-pixel points."});
  section.compared.push_back(
      {.quantity = "Yaw of a turned H by image moments, largest error",
       .unit = "deg",
       .published = kPublishedMoments_deg,
       .ours = largest(YawMethod::kMomentsOfHGray),
       .spread = fmt::format("of the binary image {}", util::Fixed(largest(YawMethod::kMomentsOfHBinary), 3)),
       .why = "All pixels are used, weighted by their darkness."});
  section.compared.push_back(
      {.quantity = "Yaw of a turned rectangle by its ellipse, largest error",
       .unit = "deg",
       .published = h_deg,
       .ours = largest(YawMethod::kEllipseOfRectangleSubpixel),
       .spread = fmt::format("whole pixels {}", util::Fixed(largest(YawMethod::kEllipseOfRectangleInteger), 3)),
       .why = "The paper states 'even smaller errors' than for the H, so the bound is the measured error of the H."});
}

void ReportRectangleFlights(const PaperPlan& plan, const Measured& measured, PaperSection& section) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.seeds; ++seed) ids.push_back(RectangleFlightId(seed));
  const FlightGroup over_rectangle(measured, ids), over_h(measured, AutonomousFlightIds(plan));
  section.paragraphs.push_back(fmt::format(
      "A pad with a solid rectangle of the size of the H instead of the H, with the network retrained on it "
      "(<code>touchdown train --letter rectangle</code>): {} of {} flights took off, hovered and landed. {} frames "
      "had a false detection.",
      over_rectangle.ended_as_expected(), over_rectangle.count(), over_rectangle.false_pads()));
  section.tables.push_back(
      {.name = "rectangle_flights",
       .caption = "The autonomous flight above both pads: RMSE relative to the truth, mean over the seeds.",
       .head = ErrorHead("letter"),
       .rows = {over_h.ErrorRow("H", "truth"), over_rectangle.ErrorRow("rectangle", "truth")}});
  section.compared.push_back(over_rectangle.Failures("Pad with a rectangle"));
}

PaperSection ReportYaw(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "yaw", .title = "Yaw from the letter (Sec. IV-C.3)"}};
  section.paragraphs.push_back(
      "A synthetic H is rotated in steps of one degree, and viewed from straight above without noise. The yaw errors "
      "are those of the major axis of the ellipse fitted to its contour, as in the estimator, of image moments, and "
      "of the ellipse fitted to a solid rectangle of the same size.");
  ReportRotatedH(measured, section);
  ReportRectangleFlights(plan, measured, section);
  return section;
}

}  // namespace

Experiment YawExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kRotation_s = 3.0, kFlight_s = 22.0;
  Experiment experiment;
  for (const double height_m : kHeights_m) {
    experiment.measurements.push_back(
        {.id = RotatedHId(height_m), .expected_s = kRotation_s, .measure = [height_m](const util::StopRequested&) {
           return MeasureRotatedH(height_m);
         }});
  }
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    runner::Scenario scenario = ShippedFlight("rectangle_pad", static_cast<std::uint64_t>(seed));
    vehicle.ApplyTo(scenario);
    experiment.measurements.push_back({.id = RectangleFlightId(seed),
                                       .expected_s = kFlight_s,
                                       .measure = [scenario](const util::StopRequested& stop_requested) {
                                         return FlyAndSummarize(scenario, {}, stop_requested);
                                       }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportYaw(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
