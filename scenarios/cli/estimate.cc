#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/cli/progress.h"
#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/datasets/footage.h"
#include "scenarios/datasets/imu_file.h"
#include "scenarios/datasets/poses_table.h"
#include "scenarios/report/footage_video.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/interrupted.h"
#include "scenarios/util/output_folder.h"
#include "scenarios/util/version.h"

namespace touchdown::cli {
namespace {

using estimator::FrameStatus;
using estimator::PoseChoice;

struct EstimateOptions {
  std::string input;
  std::string out;
  std::optional<std::string> camera, pad, imu, vehicle, calibration, estimator;
  std::vector<std::string> topics;
  bool video = false;
  OutputOptions output;
};

models::CameraModel CameraOf(const EstimateOptions& options, const runner::Calibration& calibration,
                             const datasets::FootageMetadata& metadata) {
  if (options.camera) return runner::LoadCameraModel(*options.camera);
  if (calibration.camera_model) return *calibration.camera_model;
  if (metadata.camera) return *metadata.camera;
  throw InputError(
      fmt::format("{}: contains no camera calibration; give one with --camera or --calibration", options.input));
}

datasets::SensorMounting VehicleMounting(const models::Vehicle& vehicle) {
  return {.X_BC = vehicle.X_BC(), .X_BU = vehicle.X_BU()};
}

std::optional<datasets::SensorMounting> MountingOf(const EstimateOptions& options,
                                                   const runner::Calibration& calibration,
                                                   const datasets::FootageMetadata& metadata) {
  if (options.vehicle) return VehicleMounting(runner::LoadVehicle(*options.vehicle));
  if (!calibration.camera && !calibration.imu) return metadata.mounting;
  models::Vehicle vehicle;
  datasets::SensorMounting mounting = metadata.mounting.value_or(VehicleMounting(vehicle));
  vehicle.camera = calibration.camera.value_or(vehicle.camera);
  vehicle.imu = calibration.imu.value_or(vehicle.imu);
  if (calibration.camera) mounting.X_BC = vehicle.X_BC();
  if (calibration.imu) mounting.X_BU = vehicle.X_BU();
  return mounting;
}

datasets::FootageSetup SetupOf(const EstimateOptions& options, const datasets::FootageMetadata& metadata) {
  const runner::Calibration calibration =
      options.calibration ? runner::LoadCalibration(*options.calibration) : runner::Calibration();
  datasets::FootageSetup setup;
  setup.camera = CameraOf(options, calibration, metadata);
  setup.pad = options.pad ? runner::LoadPad(*options.pad) : metadata.pad.value_or(models::LandingPad());
  setup.mounting = MountingOf(options, calibration, metadata);
  setup.imu = options.imu ? datasets::ReadImuFile(*options.imu, metadata.time) : metadata.imu;
  setup.estimator = metadata.estimator.value_or(estimator::EstimatorConfig());
  if (options.estimator) setup.estimator.name = *options.estimator;
  return setup;
}

/// Number of occurrences of each value, in the order of the values.
template <typename Value>
using Counts = std::map<Value, std::size_t>;

/// Status of a frame and the strategy's reason for it.
using StatusAndReason = std::pair<FrameStatus, std::string>;

std::string Name(const StatusAndReason& outcome) {
  return std::string(estimator::ReasonOrStatus(outcome.first, outcome.second));
}

Counts<StatusAndReason> CountStatuses(const std::vector<datasets::FootageEstimate>& estimates) {
  Counts<StatusAndReason> counts;
  for (const datasets::FootageEstimate& estimate : estimates) {
    ++counts[{estimate.result.status, estimate.result.reason}];
  }
  return counts;
}

Counts<PoseChoice::Reason> CountReasons(const std::vector<datasets::FootageEstimate>& estimates) {
  Counts<PoseChoice::Reason> counts;
  for (const datasets::FootageEstimate& estimate : estimates) {
    if (estimate.result.choice) ++counts[estimate.result.choice->reason];
  }
  return counts;
}

void PrintStatuses(const std::vector<datasets::FootageEstimate>& estimates) {
  fmt::print("{} frames\n", estimates.size());
  for (const auto& [status, count] : CountStatuses(estimates)) {
    fmt::print("  {:<13} {:>6}  {:5.1f} %\n", Name(status), count,
               100.0 * static_cast<double>(count) / static_cast<double>(estimates.size()));
  }
}

void PrintChoices(const std::vector<datasets::FootageEstimate>& estimates) {
  Counts<PoseChoice::Reason> counts = CountReasons(estimates);
  const std::size_t by_residual = counts[PoseChoice::Reason::kArtwork], frontal = counts[PoseChoice::Reason::kFrontal];
  if (by_residual + frontal == 0) return;
  fmt::print(
      "without an IMU, each frame has two pose hypotheses; choices.csv lists which one was chosen:\n"
      "  {} frames by the smaller residual of the H and the ring's inner edge\n"
      "  {} frames by the more frontal view, because both residuals are alike\n",
      by_residual, frontal);
}

/// Content of summary.json.
std::string SummaryJson(const std::vector<datasets::FootageEstimate>& estimates, const datasets::FootageSetup& setup) {
  nlohmann::ordered_json json;
  json["schema"] = 1;
  json["version"] = util::Version();
  json["estimator"] = setup.estimator.name;
  json["pose_of"] = setup.mounting ? "body" : "camera";
  json["imu"] = !setup.imu.empty();
  json["frames"] = estimates.size();
  json["statuses"] = nlohmann::ordered_json::object();
  for (const auto& [status, count] : CountStatuses(estimates)) json["statuses"][Name(status)] = count;
  json["pose_choices"] = nlohmann::ordered_json::object();
  for (const auto& [reason, count] : CountReasons(estimates)) json["pose_choices"][std::string(Name(reason))] = count;
  return json.dump(2) + "\n";
}

constexpr const char* kVideoName = "estimate.mp4";
/// Start of poses.csv, by which an earlier output directory is recognized.
constexpr const char* kPosesSignature = "frame,source,t_s,status,x_m";

int EstimateWith(const EstimateOptions& options) {
  util::OutputFolder folder(
      options.out,
      {.files = {"poses.csv", "poses.tum", "choices.csv", "summary.json", kVideoName}, .signature = kPosesSignature});
  const std::unique_ptr<datasets::Footage> footage = datasets::OpenFootage(options.input, options.topics);
  const datasets::FootageMetadata& metadata = footage->metadata();
  const datasets::FootageSetup setup = SetupOf(options, metadata);

  std::optional<report::FootageVideo> video;
  if (options.video) video.emplace(folder.PathOf(kVideoName), setup, metadata);
  const std::vector<datasets::FootageEstimate> estimates = [&] {
    Progress progress(!options.output.ForPeople());
    std::size_t done = 0;
    return datasets::EstimateFootage(
        *footage, setup, [&](const datasets::FootageFrame& frame, const datasets::FootageEstimate& estimate) {
          if (InterruptRequested()) throw util::Interrupted();
          if (video) video->Add(frame, estimate);
          ++done;
          const std::size_t count = std::max(done, metadata.frame_count);
          if (progress.IsDue()) {
            progress.Update(static_cast<double>(done) / static_cast<double>(count), fmt::format("{} frames", done));
          }
        });
  }();

  if (video) video->Finish();
  const std::string summary = SummaryJson(estimates, setup);
  folder.Write("summary.json", summary);
  folder.Write("poses.tum", runner::TumText(datasets::PosesTrajectory(estimates, metadata.time), metadata.time));
  folder.Write("choices.csv", datasets::ChoicesCsv(estimates));
  folder.Write("poses.csv", datasets::PosesCsv(estimates, metadata.time));
  folder.Commit();
  if (options.output.json) fmt::print("{}", summary);
  if (!options.output.ForPeople()) return kPassed;
  PrintStatuses(estimates);
  PrintChoices(estimates);
  fmt::print("poses of the {} in W, X_W{}; files in {}\n", setup.mounting ? "body" : "camera",
             setup.mounting ? 'B' : 'C', options.out);
  return kPassed;
}

}  // namespace

void AddEstimate(CLI::App& app, Run& run) {
  const auto options = std::make_shared<EstimateOptions>();
  CLI::App& command = *app.add_subcommand("estimate", "Run the estimator alone, on recorded footage");
  command.add_option("INPUT", options->input, "Directory of images, video, recording in EuRoC format, or ROS 1 bag")
      ->required();
  command.add_option("--out", options->out, "Output directory")->required()->type_name("DIR");
  command
      .add_option("--camera", options->camera, "Camera calibration as ROS camera_info YAML (default: the recording's)")
      ->type_name("CAMERA.yaml");
  command.add_option("--pad", options->pad, "Pad description (default: the recording's, else the built-in pad)")
      ->type_name("PAD.yaml");
  command.add_option("--imu", options->imu, "IMU samples in EuRoC format (default: the recording's)")
      ->type_name("FILE");
  command
      .add_option("--vehicle", options->vehicle,
                  "Vehicle description with the mounting of camera and IMU (default: the recording's)")
      ->type_name("VEHICLE.yaml");
  command
      .add_option("--calibration", options->calibration,
                  "Camera calibration and mountings as written by touchdown calibrate; entries that it lacks are the "
                  "recording's")
      ->type_name("CALIBRATION.yaml")
      ->excludes("--camera", "--vehicle");
  command
      .add_option("--topic", options->topics, "Topic to use from a bag with several cameras or IMUs; may be repeated")
      ->type_name("TOPIC")
      ->allow_extra_args(false);
  command.add_option("--estimator", options->estimator, "Name of the estimator (default: paper)")->type_name("NAME");
  command.add_flag("--video", options->video,
                   "Write a video with the estimator's results drawn into the frames, estimate.mp4");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return EstimateWith(*options); }; });
}

}  // namespace touchdown::cli
