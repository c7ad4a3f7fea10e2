// Computation time per frame, compared with AprilTag 3 on the same frames in the same run (`make bench`). The exit
// status is 1 if vision takes more than a quarter of the time of undecimated AprilTag.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

#include "estimator/paper/paper_estimator.h"
#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/april_tag.h"
#include "sim/dynamics/world.h"
#include "sim/sensors/camera.h"

namespace {

using namespace touchdown;

constexpr int kFrames = 24;
constexpr const char *kVision = "vision", *kAprilTag = "AprilTag/undecimated";
constexpr double kMaxFractionOfAprilTag = 0.25;

struct View {
  models::Image image;
  Eigen::Vector3d gravity_B;
};

/// Cluttered frames of the default camera: heights from 0.3 to 1.5 m, offsets up to 0.3 m, tilts up to 15 degrees.
std::vector<View> RenderViews(bool with_pad) {
  std::vector<View> result;
  models::RandomStream random(1, "benchmark.views");
  for (int i = 0; i < kFrames; ++i) {
    const models::Vehicle vehicle;
    const models::TimeBase time;
    sim::SceneConfig config;
    config.pad = with_pad;
    const sim::Scene scene = sim::MakeScene(config, {}, static_cast<std::uint64_t>(1 + i / 6));
    sim::World world({}, vehicle, scene, time, 1);
    sim::Camera camera({}, vehicle.X_BC(), world, time, 1);
    sim::TrueState state;
    state.X_WB.translation() << random.Uniform(-0.3, 0.3), random.Uniform(-0.3, 0.3), random.Uniform(0.3, 1.5);
    state.X_WB.linear() = models::RotationFromTaitBryan(
        {random.Uniform(-0.26, 0.26), random.Uniform(-0.26, 0.26), random.Uniform(-models::kPi, models::kPi)});
    for (std::optional<models::CameraFrame> frame; !frame; ++state.tick) {
      if ((frame = camera.Sample(state))) {
        result.push_back({frame->image, -state.X_WB.linear().transpose() * Eigen::Vector3d::UnitZ()});
      }
    }
  }
  return result;
}

const std::vector<View>& Views(bool with_pad = true) {
  static const std::vector<View> with = RenderViews(true), without = RenderViews(false);
  return with_pad ? with : without;
}

/// Time per frame. Also reports the fraction of frames with a detected pad, and the time of the slowest frame.
void Vision(benchmark::State& state, bool with_pad, estimator::FrameOrder frame_order) {
  estimator::EstimatorSetup setup;
  setup.frame_order = frame_order;
  setup.X_BC = models::Vehicle().X_BC();
  const auto& views = Views(with_pad);
  estimator::paper::PaperEstimator estimator(setup);
  models::Tick tick = 0;
  int ok = 0, frames = 0;
  std::vector<double> shortest_ms(kFrames, 1e9);
  for (auto _ : state) {
    const std::size_t i = static_cast<std::size_t>(frames++) % kFrames;
    const View& view = views[i];
    const auto start = std::chrono::steady_clock::now();
    // The views are unrelated. Intervals of a second disable the outlier rule.
    ok += estimator.Estimate(view.image.View(), tick += 1200, view.gravity_B).pose.has_value();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    shortest_ms[i] = std::min(shortest_ms[i], elapsed.count());
  }
  state.counters["found"] = static_cast<double>(ok) / frames;
  state.counters["slowest_ms"] =
      *std::max_element(shortest_ms.begin(), shortest_ms.begin() + std::min(frames, kFrames));
}
BENCHMARK_CAPTURE(Vision, with_pad, true, estimator::FrameOrder::kFlight)->Name(kVision)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Vision, without_pad, false, estimator::FrameOrder::kFlight)
    ->Name("vision/without_pad")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Vision, footage_without_pad, false, estimator::FrameOrder::kUnrelated)
    ->Name("vision/footage_without_pad")
    ->Unit(benchmark::kMillisecond);

void AprilTag(benchmark::State& state, float decimate) {
  const auto& views = Views();
  experiments::AprilTagDetector detector(decimate);
  int frames = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(detector.Detect(views[static_cast<std::size_t>(frames++) % kFrames].image.View()));
  }
}
BENCHMARK_CAPTURE(AprilTag, undecimated, 1.0F)->Name(kAprilTag)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AprilTag, decimated_by_2, 2.0F)->Unit(benchmark::kMillisecond);

/// One camera period of the simulation: 20 physics ticks and a frame.
void SimulatedCameraPeriod(benchmark::State& state, sim::SceneConfig::Setting setting) {
  const models::Vehicle vehicle;
  const models::TimeBase time;
  sim::World world({}, vehicle, sim::MakeScene({.setting = setting}, {}, 1), time, 1);
  sim::Camera camera({}, vehicle.X_BC(), world, time, 1);
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation().z() = 1.0;
  models::RotorCommand hover;
  hover.speed_rad_s.fill(vehicle.rotor.SpeedFor(vehicle.HoverThrustPerRotor()));
  // Without a controller, the vehicle drifts by millimeters.
  world.Reset(X_WB, true);
  for (auto _ : state) {
    for (int tick = 0; tick < 20; ++tick) {
      benchmark::DoNotOptimize(camera.Sample(world.state()));
      world.Step(hover);
    }
  }
}
BENCHMARK_CAPTURE(SimulatedCameraPeriod, indoor, sim::SceneConfig::Setting::kIndoor)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(120);
BENCHMARK_CAPTURE(SimulatedCameraPeriod, outdoor, sim::SceneConfig::Setting::kOutdoor)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(120);

/// Prints the runs and stores their times.
class Reporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) time_ms_[run.run_name.function_name] = run.GetAdjustedCPUTime();
  }

  /// Whether vision takes at most the allowed fraction of AprilTag's time. True if one of them was not run.
  bool VisionIsFastEnough() const {
    const auto vision = time_ms_.find(kVision), april_tag = time_ms_.find(kAprilTag);
    if (vision == time_ms_.end() || april_tag == time_ms_.end()) return true;
    const double fraction = vision->second / april_tag->second;
    const bool good = fraction <= kMaxFractionOfAprilTag;
    std::printf("%s: vision takes %.3f of undecimated AprilTag's time, limit %.2f\n", good ? "pass" : "FAIL", fraction,
                kMaxFractionOfAprilTag);
    return good;
  }

 private:
  std::map<std::string, double> time_ms_;
};

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return reporter.VisionIsFastEnough() ? 0 : 1;
}
