#include "scenarios/experiments/pad_size.h"

#include <array>
#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/static_scene.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

using models::RandomStream;

constexpr std::array<double, 6> kRadii_m = {0.045, 0.060, 0.090, 0.120, 0.150, 0.180};
constexpr double kLowest_m = 0.03, kHighest_m = 8.0, kStep = 1.18;  // Heights of the camera over the pad.
constexpr double kMinFoundFraction = 0.9;

/// The built-in pad, scaled to another radius.
models::LandingPad PadOfRadius(double radius_m) {
  models::LandingPad pad;
  const double scale = radius_m / pad.outer_radius_m;
  for (double* const size : {&pad.outer_radius_m, &pad.ring_width_m, &pad.h_height_m, &pad.h_width_m, &pad.h_stroke_m,
                             &pad.sheet_length_m, &pad.sheet_width_m}) {
    *size *= scale;
  }
  return pad;
}

/// Draws a nearly level body pose above the pad, as in a hover or a landing. `height_m` is the height of the camera.
Eigen::Isometry3d DrawPose(double height_m, const Eigen::Isometry3d& X_BC, RandomStream& random) {
  constexpr double kTilt_rad = models::DegToRad(2.0), kOffset = 0.05;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan(
      {kTilt_rad * random.Normal(), kTilt_rad * random.Normal(), random.Uniform(-1.4, 1.4)});
  const Eigen::Vector3d p_WC(kOffset * height_m * random.Normal(), kOffset * height_m * random.Normal(), height_m);
  X_WB.translation() = p_WC - X_WB.linear() * X_BC.translation();
  return X_WB;
}

Json MeasurePadSize(const PaperVehicle& vehicle, double radius_m, int frames,
                    const util::StopRequested& stop_requested) {
  const auto seed = static_cast<std::uint64_t>(std::lround(1e3 * radius_m));
  runner::Scenario nominal;
  vehicle.ApplyTo(nominal);
  nominal.pad = PadOfRadius(radius_m);
  StaticScene scene(nominal, sim::MakeScene({}, nominal.pad, seed), seed);
  RandomStream random(seed, "paper.pad_size");
  Json heights = Json::array();
  for (double height_m = kLowest_m; height_m < kHighest_m; height_m *= kStep) {
    int found = 0;
    for (int i = 0; i < frames; ++i) {
      if (stop_requested && stop_requested()) throw util::Interrupted();
      const Eigen::Isometry3d X_WB = DrawPose(height_m, vehicle.truth.X_BC(), random);
      const models::Image image = scene.Capture({.X_WC = X_WB * vehicle.truth.X_BC()});
      const auto estimate = scene.Estimate(image, DownInBody(X_WB));
      // An error below a third of the height means that the correct ring was found.
      if (estimate.pose && (estimate.pose->X_WB.translation() - X_WB.translation()).norm() < height_m / 3.0) ++found;
    }
    heights.push_back({height_m, found});
  }
  return heights;
}

std::string PadSizeId(double radius_m) { return fmt::format("pad_size_{:.0f}_mm", 1e3 * radius_m); }

/// The longest interval of heights at which the pad is found in at least kMinFoundFraction of the frames.
std::pair<double, double> WorkingRange(const Json& heights, int frames) {
  std::pair<double, double> longest{0.0, 0.0}, run{0.0, 0.0};
  for (const Json& row : heights) {
    const double height_m = row[0].get<double>();
    if (row[1].get<int>() < kMinFoundFraction * frames) {
      run = {0.0, 0.0};
      continue;
    }
    run = {run.first == 0.0 ? height_m : run.first, height_m};
    if (run.second - run.first >= longest.second - longest.first) longest = run;
  }
  return longest;
}

PaperSection ReportPadSize(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "pad-size", .title = "Working distance and blind range (Sec. III-B)"}};
  section.paragraphs.push_back(fmt::format(
      "\"A larger radius would lead to a larger working distance for the vision system, but would lead to a larger "
      "'blind' range.\" The pad is scaled to other radii in a cluttered room, with {} camera poses at each height. The "
      "table lists the heights of the camera between which the pad is found in at least {:.0f} % of the frames. "
      "Successive heights differ by {:.0f} %.",
      plan.trade_frames, 100.0 * kMinFoundFraction, 100.0 * (kStep - 1.0)));
  report::ReportTable table{.name = "pad_size",
                            .caption = "Outer radius of the pad, and the camera heights between which it is found.",
                            .head = {"radius, mm", "blind below, m", "working up to, m", "ratio"}};
  std::string csv = "radius_mm,blind_below_m,working_up_to_m\n";
  for (const double radius_m : kRadii_m) {
    const auto [low, high] = WorkingRange(measured.at(PadSizeId(radius_m)), plan.trade_frames);
    table.rows.push_back({util::Fixed(1e3 * radius_m, 0), util::Fixed(low, 2), util::Fixed(high, 2),
                          low > 0.0 ? util::Fixed(high / low, 0) : "none"});
    csv += util::CsvLine({util::Fixed(1e3 * radius_m, 0), util::Fixed(low, 4), util::Fixed(high, 4)});
  }
  section.tables.push_back(std::move(table));
  section.figures.push_back(
      {.name = "pad_size",
       .title = "Working distance and blind range",
       .caption = "Both limits are proportional to the size of the pad; their ratio depends on the camera alone.",
       .csv = csv,
       .plot = "set key top left\nset xlabel 'outer radius of the pad, mm'\nset ylabel 'height of the camera, m'\n"
               "set logscale y\nset yrange [0.03:10]\n"
               "plot data using 'radius_mm':'working_up_to_m' with linespoints pt 7 ps 0.7 lw 1.6 lc rgb ESTIMATE "
               "title 'working distance', \\\n"
               "     data using 'radius_mm':'blind_below_m' with linespoints pt 7 ps 0.7 lw 1.6 lc rgb SET_POINT title "
               "'blind range'\n",
       .width_cm = 13.0});
  return section;
}

}  // namespace

Experiment PadSizeExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kFrame_s = 0.02, kHeights = 32.0, kRoom_s = 3.0;
  Experiment experiment;
  for (const double radius_m : kRadii_m) {
    experiment.measurements.push_back(
        {.id = PadSizeId(radius_m),
         .expected_s = kRoom_s + kFrame_s * kHeights * plan.trade_frames,
         .measure = [vehicle, radius_m, frames = plan.trade_frames](const util::StopRequested& stop_requested) {
           return MeasurePadSize(vehicle, radius_m, frames, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportPadSize(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
