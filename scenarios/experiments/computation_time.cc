#include "scenarios/experiments/computation_time.h"

#include <algorithm>
#include <array>

#include "scenarios/experiments/april_tag.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/runner/closed_loop.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/stopwatch.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr double kPublishedMean_ms = 11.0;
constexpr double kMaxAprilTagRatio = 0.25;

/// Runs AprilTag 3 on every fourth frame, in the same run on the same core, and measures its computation time.
class AprilTagTimer final : public runner::FlightObserver {
 public:
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& /*estimate*/,
               const runner::FrameRecord& record) override {
    constexpr int kEvery = 4;
    if (count_++ % kEvery != 0) return;
    const util::Stopwatch stopwatch;
    april_tag_.Detect(frame.image.View());
    april_tag_ms_.push_back(stopwatch.milliseconds());
    vision_ms_.push_back(record.vision_ms);
  }

  const std::vector<double>& april_tag_ms() const { return april_tag_ms_; }
  const std::vector<double>& vision_ms() const { return vision_ms_; }

 private:
  AprilTagDetector april_tag_;
  int count_ = 0;
  std::vector<double> april_tag_ms_, vision_ms_;
};

Json MeasureComputationTime(const runner::Scenario& scenario, const util::StopRequested& stop_requested) {
  AprilTagTimer timer;
  runner::FlightObserver* const observers[] = {&timer};
  const runner::FlightLog log = runner::FlyClosedLoop(scenario, observers, stop_requested);
  Json frames = Json::array();
  for (const runner::FrameRecord& frame : log.frames) {
    frames.push_back({log.time.ToSeconds(frame.mid_exposure), frame.X_WB.translation().z(),
                      frame.vision_ms - frame.geometry_ms, frame.geometry_ms, frame.ring_in_view ? 1 : 0});
  }
  return {{"frames", std::move(frames)},
          {"april_tag_ms", util::Mean(timer.april_tag_ms())},
          {"vision_ms_same_frames", util::Mean(timer.vision_ms())}};
}

struct FrameCost {
  double t_s, height_m, recognition_ms, geometry_ms;
  bool ring_in_view;

  double total_ms() const { return recognition_ms + geometry_ms; }
};

std::vector<FrameCost> CostsOf(const Json& measured) {
  std::vector<FrameCost> costs;
  for (const Json& row : measured.at("frames")) {
    costs.push_back({row[0].get<double>(), row[1].get<double>(), row[2].get<double>(), row[3].get<double>(),
                     row[4].get<int>() != 0});
  }
  return costs;
}

/// The values of the frames for which `value_of` returns one.
std::vector<double> ValuesOf(const std::vector<FrameCost>& costs,
                             const std::function<std::optional<double>(const FrameCost&)>& value_of) {
  std::vector<double> values;
  for (const FrameCost& cost : costs) {
    if (const auto value = value_of(cost)) values.push_back(*value);
  }
  return values;
}

report::ReportTable ByHeight(const std::vector<FrameCost>& costs) {
  constexpr std::array<double, 6> kEdges_m = {0.2, 0.3, 0.45, 0.65, 0.9, 1.2};
  report::ReportTable table{
      .name = "computation_time_by_height",
      .caption = "Mean time per frame by the height of the body, for frames with the whole ring in view.",
      .head = {"height, m", "frames", "recognition, ms", "geometry, ms"}};
  for (std::size_t i = 0; i + 1 < kEdges_m.size(); ++i) {
    const double low = kEdges_m[i], high = kEdges_m[i + 1];
    const auto values_in_bin = [&](double FrameCost::*member) {
      return ValuesOf(costs, [&](const FrameCost& cost) {
        const bool in_bin = cost.ring_in_view && cost.height_m >= low && cost.height_m < high;
        return in_bin ? std::optional(cost.*member) : std::nullopt;
      });
    };
    const std::vector<double> recognition = values_in_bin(&FrameCost::recognition_ms),
                              geometry = values_in_bin(&FrameCost::geometry_ms);
    if (recognition.empty()) continue;
    table.rows.push_back({fmt::format("{:.2f} to {:.2f}", low, high), std::to_string(recognition.size()),
                          util::Fixed(util::Mean(recognition), 2), util::Fixed(util::Mean(geometry), 2)});
  }
  return table;
}

PaperSection ReportComputationTime(const Measured& measured) {
  const Json& json = measured.at(kComputationTimeId);
  const std::vector<FrameCost> costs = CostsOf(json);
  const std::vector<double> total =
      ValuesOf(costs, [](const FrameCost& cost) { return std::optional(cost.total_ms()); });
  const double ratio = json.at("vision_ms_same_frames").get<double>() / json.at("april_tag_ms").get<double>();
  PaperSection section{{.id = "computation-time", .title = "Computation time (Sec. VI-B.4, Fig. 9)"}};
  section.paragraphs.push_back(fmt::format(
      "The autonomous flight with seed 1, on one core, with no concurrent measurements. Recognition comprises all "
      "steps from the image to the pad candidates. Geometry comprises edges, ellipses, the template check and the "
      "pose. A frame takes {} ms on average, and {} ms at the 99th percentile. AprilTag 3 without decimation takes "
      "{} ms on average, measured on every fourth frame of the same run. The onboard computer of the paper is a 1.86 "
      "GHz Core 2 Duo, so the absolute times are not comparable, but the fractions and the growth are.",
      util::Fixed(util::Mean(total), 2), util::Fixed(util::Quantile(total, 0.99), 2),
      util::Fixed(json.at("april_tag_ms").get<double>(), 1)));
  std::string csv = "t_s,height_m,recognition_ms,geometry_ms,total_ms\n";
  for (const FrameCost& cost : costs) {
    csv += util::CsvLine({util::Fixed(cost.t_s, 4), util::Fixed(cost.height_m, 4), util::Fixed(cost.recognition_ms, 3),
                          util::Fixed(cost.geometry_ms, 3), util::Fixed(cost.total_ms(), 3)});
  }
  section.figures.push_back(
      {.name = "fig_9_computation_time",
       .title = "Fig. 9: computation time",
       .caption = "Time per frame during the flight. Thin line: height (right axis).",
       .csv = csv,
       .plot = fmt::format(
           "set key top left horizontal\nset xlabel 't, s'\nset ylabel 'time per frame, ms'\n"
           "set y2label 'height, m' textcolor rgb MUTED\nset y2tics textcolor rgb MUTED\n"
           "set y2range [0:2]\nset yrange [0:{}]\n"
           "plot data using 't_s':'height_m' axes x1y2 with lines lw 0.8 lc rgb MUTED title 'height', \\\n"
           "     data using 't_s':'total_ms' with lines lw 1 lc rgb INK title 'whole', \\\n"
           "     data using 't_s':'recognition_ms' with lines lw 1 lc rgb ESTIMATE title 'recognition', \\\n"
           "     data using 't_s':'geometry_ms' with lines lw 1 lc rgb SET_POINT title 'geometry'\n",
           util::Fixed(1.6 * util::Quantile(total, 0.995), 1))});
  section.tables.push_back(ByHeight(costs));
  section.compared.push_back(
      {.quantity = "Vision per frame, mean over the autonomous flight",
       .unit = "ms",
       .published = kPublishedMean_ms,
       .ours = util::Mean(total),
       .spread = fmt::format("99th percentile {}", util::Fixed(util::Quantile(total, 0.99), 2)),
       .why = "The processor is faster than the paper's 1.86 GHz Core 2 Duo; see the ratio to AprilTag 3."});
  section.compared.push_back(
      {.quantity = "Vision over AprilTag 3, same frames",
       .unit = "",
       .published = std::nullopt,
       .ours = ratio,
       .spread = fmt::format("our own bound {}", kMaxAprilTagRatio),
       .why = "The paper has no such comparison. AprilTag 3 runs without decimation, on one thread."});
  return section;
}

}  // namespace

Experiment ComputationTimeExperiment(const PaperPlan& /*plan*/, const PaperVehicle& vehicle) {
  runner::Scenario scenario = ShippedFlight("takeoff_hover_land", 1);
  vehicle.ApplyTo(scenario);
  constexpr double kFlight_s = 26.0;
  return {.measurements = {{.id = kComputationTimeId,
                            .expected_s = kFlight_s,
                            .alone = true,
                            .measure =
                                [scenario](const util::StopRequested& stop_requested) {
                                  return MeasureComputationTime(scenario, stop_requested);
                                }}},
          .report = ReportComputationTime};
}

}  // namespace touchdown::experiments
