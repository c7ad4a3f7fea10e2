#include "scenarios/experiments/computation_time.h"

#include <algorithm>
#include <array>

#include "scenarios/experiments/april_tag.h"
#include "scenarios/experiments/flown_flight.h"
#include "scenarios/runner/closed_loop.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/stopwatch.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

constexpr double kPublishedMean_ms = 11.0;
constexpr double kMostOfAprilTag = 0.25;

/// Has AprilTag 3 look at a part of the frames too, in the same run, on the same core.
class AprilTagWatch final : public runner::FlightObserver {
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
  AprilTagWatch watch;
  runner::FlightObserver* const observers[] = {&watch};
  const runner::FlightLog log = runner::FlyClosedLoop(scenario, observers, stop_requested);
  Json frames = Json::array();
  for (const runner::FrameRecord& frame : log.frames) {
    frames.push_back({log.time.ToSeconds(frame.mid_exposure), frame.X_WB.translation().z(),
                      frame.vision_ms - frame.geometry_ms, frame.geometry_ms, frame.ring_in_view ? 1 : 0});
  }
  return {{"frames", std::move(frames)},
          {"april_tag_ms", util::Mean(watch.april_tag_ms())},
          {"vision_ms_same_frames", util::Mean(watch.vision_ms())}};
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

std::vector<double> Of(const std::vector<FrameCost>& costs,
                       const std::function<std::optional<double>(const FrameCost&)>& what) {
  std::vector<double> values;
  for (const FrameCost& cost : costs) {
    if (const auto value = what(cost)) values.push_back(*value);
  }
  return values;
}

report::ReportTable ByHeight(const std::vector<FrameCost>& costs) {
  constexpr std::array<double, 6> kEdges_m = {0.2, 0.3, 0.45, 0.65, 0.9, 1.2};
  report::ReportTable table{.name = "computation_time_by_height",
                            .caption = "Mean per frame by the body's height, over the frames that show the ring whole.",
                            .head = {"height, m", "frames", "recognition, ms", "geometry, ms"}};
  for (std::size_t i = 0; i + 1 < kEdges_m.size(); ++i) {
    const double low = kEdges_m[i], high = kEdges_m[i + 1];
    const auto part = [&](double FrameCost::*member) {
      return Of(costs, [&](const FrameCost& cost) {
        const bool within = cost.ring_in_view && cost.height_m >= low && cost.height_m < high;
        return within ? std::optional(cost.*member) : std::nullopt;
      });
    };
    const std::vector<double> recognition = part(&FrameCost::recognition_ms), geometry = part(&FrameCost::geometry_ms);
    if (recognition.empty()) continue;
    table.rows.push_back({fmt::format("{:.2f} to {:.2f}", low, high), std::to_string(recognition.size()),
                          util::Fixed(util::Mean(recognition), 2), util::Fixed(util::Mean(geometry), 2)});
  }
  return table;
}

PaperSection ReportComputationTime(const Measured& measured) {
  const Json& json = measured.at(kComputationTimeId);
  const std::vector<FrameCost> costs = CostsOf(json);
  const std::vector<double> total = Of(costs, [](const FrameCost& cost) { return std::optional(cost.total_ms()); });
  const double ratio = json.at("vision_ms_same_frames").get<double>() / json.at("april_tag_ms").get<double>();
  PaperSection section{{.id = "computation-time", .title = "Computation time (Sec. VI-B.4, Fig. 9)"}};
  section.paragraphs.push_back(fmt::format(
      "The autonomous flight of seed 1, one core, nothing beside it that this program runs. Recognition is everything "
      "from the image to what may be the pad; geometry is edges, ellipses, the print's check, and the pose. A frame "
      "takes {} ms in the mean, {} ms at the 99th percentile. AprilTag 3, undecimated, takes {} ms for every fourth of "
      "the same frames in the same run. The paper's onboard computer is a 1.86 GHz Core 2 Duo: times are not "
      "comparable, shares and growth are.",
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
       .caption = "Per frame over the flight; the thin line is the height (right axis).",
       .csv = csv,
       .plot = fmt::format(
           "set key top left horizontal\nset xlabel 't, s'\nset ylabel 'ms a frame'\nset y2label 'height, m' textcolor "
           "rgb MUTED\nset y2tics textcolor rgb MUTED\nset y2range [0:2]\nset yrange [0:{}]\n"
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
       .why = "A faster processor than the paper's 1.86 GHz Core 2 Duo; see the ratio to AprilTag 3."});
  section.compared.push_back({.quantity = "Vision over AprilTag 3, same frames",
                              .unit = "",
                              .published = std::nullopt,
                              .ours = ratio,
                              .spread = fmt::format("our own bound {}", kMostOfAprilTag),
                              .why = "The paper does not compare; AprilTag 3 is undecimated, one thread."});
  return section;
}

}  // namespace

Experiment ComputationTimeExperiment(const PaperPlan& /*plan*/, const PaperVehicle& vehicle) {
  runner::Scenario scenario = ShippedFlight("takeoff_hover_land", 1);
  vehicle.Equip(scenario);
  constexpr double kFlight_s = 26.0;
  return {.measurements = {{.id = kComputationTimeId,
                            .expected_s = kFlight_s,
                            .alone = true,
                            .take =
                                [scenario](const util::StopRequested& stop_requested) {
                                  return MeasureComputationTime(scenario, stop_requested);
                                }}},
          .report = ReportComputationTime};
}

}  // namespace touchdown::experiments
