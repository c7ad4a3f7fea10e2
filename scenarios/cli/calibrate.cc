#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/cli/progress.h"
#include "scenarios/config/camera_info.h"
#include "scenarios/datasets/imu_file.h"
#include "scenarios/laboratory/calibration_bench.h"
#include "scenarios/laboratory/calibration_files.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/interrupted.h"
#include "scenarios/util/output_folder.h"

namespace touchdown::cli {
namespace {

struct CalibrateOptions {
  std::string what;
  std::optional<std::string> scenario;
  std::optional<std::string> imu;
  std::vector<std::string> overrides;
  std::optional<std::string> seed;
  bool all_terms = false;
  std::string out;
  OutputOptions output;

  bool Wants(const char* sensor) const { return what == sensor || what == "all"; }
};

/// The samples that the file marks as at rest, or all samples of a file without such marks.
std::vector<models::ImuSample> SamplesAtRest(const std::string& file) {
  constexpr models::TimeBase kMicroseconds{.ticks_per_s = 1'000'000};
  const std::vector<datasets::ImuReading> readings = datasets::ReadImuFile(file, kMicroseconds);
  const bool has_rest_marks = std::any_of(readings.begin(), readings.end(), [](const auto& r) { return r.at_rest; });
  std::vector<models::ImuSample> samples;
  for (const datasets::ImuReading& reading : readings) {
    if (reading.at_rest || !has_rest_marks) samples.push_back(reading.sample);
  }
  return samples;
}

/// Calibrates the IMU of a real vehicle from samples taken at rest on level ground.
laboratory::ImuCalibration CalibrateRealImu(const std::string& file) {
  try {
    return laboratory::ImuCalibrationFrom(SamplesAtRest(file));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

runner::Scenario ScenarioOf(const CalibrateOptions& options) {
  std::vector<runner::Override> overrides(options.overrides.begin(), options.overrides.end());
  if (options.seed) overrides.emplace_back("seed=" + *options.seed, "--seed " + *options.seed);
  return runner::LoadScenario(options.scenario.value(), overrides);
}

laboratory::CalibrationRun Calibrate(const CalibrateOptions& options) {
  if (options.imu && (options.scenario || options.what != "imu")) {
    throw InputError("--imu FILE replaces SCENARIO, and works only with calibrate imu");
  }
  if (options.imu) return {.scenario = {}, .imu = CalibrateRealImu(*options.imu), .camera = {}};
  if (!options.scenario) throw InputError("calibrate: needs SCENARIO, or the samples of a real IMU with --imu FILE");
  laboratory::CalibrationRun run{.scenario = ScenarioOf(options), .imu = {}, .camera = {}};
  if (options.Wants("imu")) run.imu = laboratory::CalibrateImu(*run.scenario);
  if (!options.Wants("camera")) return run;
  Progress progress(!options.output.ForPeople());
  laboratory::CameraCalibrationConfig config;
  if (options.all_terms) config.terms = laboratory::LensTerms::kAll;
  run.camera = laboratory::CalibrateCamera(*run.scenario, config, [&](double fraction) {
    if (InterruptRequested()) throw util::Interrupted();
    if (progress.IsDue()) progress.Update(fraction, "views of the chessboard");
  });
  return run;
}

int CalibrateWith(const CalibrateOptions& options) {
  util::OutputFolder folder(options.out, {.files = {"calibration.json", "calibration.yaml", "camera.yaml", "views.png"},
                                          .signature = "\"touchdown.calibration\""});
  const laboratory::CalibrationRun run = Calibrate(options);
  const std::string json = laboratory::CalibrationJson(run);
  folder.Write("calibration.json", json);
  folder.Write("calibration.yaml", runner::CalibrationYaml(CalibrationOf(run)));
  if (run.camera) {
    folder.Write("camera.yaml", config::CameraInfoYaml(run.camera->fit.model, "camera"));
    folder.Write("views.png", laboratory::CalibrationViewsPng(*run.camera, laboratory::Chessboard()));
  }
  folder.Commit();
  if (options.output.json) fmt::print("{}", json);
  if (options.output.ForPeople()) {
    fmt::print("{}{}/calibration.yaml: use it in a scenario as its calibration\n", laboratory::CalibrationText(run),
               options.out);
  }
  return kPassed;
}

}  // namespace

void AddCalibrate(CLI::App& app, Run& run) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App& command =
      *app.add_subcommand("calibrate", "Calibrate the intrinsics of the camera and the mounting of camera and IMU");
  command.add_option("WHAT", options->what, "What to calibrate: imu, camera or all")
      ->required()
      ->check(CLI::IsMember({"imu", "camera", "all"}));
  command.add_option("SCENARIO", options->scenario, "YAML file of the scenario whose vehicle is calibrated");
  command.add_option("--out", options->out, "Output directory")->required()->type_name("DIR");
  command
      .add_option("--imu", options->imu,
                  "Samples of a real IMU at rest on level ground, in EuRoC format; replaces SCENARIO")
      ->type_name("FILE");
  command
      .add_option("--set", options->overrides,
                  "Override a key of the scenario, for example --set camera.noise_sigma=5; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", options->seed, "Seed of all random sources (default: the scenario's)")->type_name("N");
  command.add_flag("--all-terms", options->all_terms,
                   "Also estimate the distortion terms p1, p2 and k3; the paper estimates k1 and k2 only");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return CalibrateWith(*options); }; });
}

}  // namespace touchdown::cli
