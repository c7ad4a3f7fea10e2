#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/flight_folder.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/cli/progress.h"
#include "scenarios/config/config_writer.h"
#include "scenarios/report/junit.h"
#include "scenarios/runner/expected_duration.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/output_file.h"

namespace touchdown::cli {
namespace {

struct FlyOptions {
  std::string scenario;
  std::vector<std::string> from;  ///< Output directory of a sweep, and id of a flight.
  std::vector<std::string> overrides;
  std::optional<std::string> seed;
  std::optional<std::string> estimator;
  std::optional<std::string> out;
  std::optional<std::string> junit;
  std::string video = "on";
  bool record = false;
  bool bag = false;
  OutputOptions output;
};

void PrintResult(const runner::Scenario& scenario, const runner::FlightResult& result, const std::string& out) {
  fmt::print("{}, seed {}, estimator {}\n", scenario.name, scenario.seed, scenario.estimator.name);
  for (const runner::Check& check : result.checks) {
    const std::string value = check.value ? fmt::format("{:.4g}", *check.value) : check.text;
    fmt::print("  {}  {:<32} {:>10} {:<4} {}\n", check.pass ? "pass" : "FAIL", check.name,
               value.empty() ? "none" : value, check.unit, check.limit);
  }
  fmt::print("{} ({}): {}\n", Name(result.outcome), result.reason, Name(result.verdict));
  fmt::print("{:.1f} s simulated at {:.2f} times real time, vision {:.1f} ms per frame; files in {}\n",
             result.metrics.at("flight.sim_time_s"), result.timing.realtime_factor, result.timing.vision_ms_mean, out);
}

/// Prints the progress of a flight.
class FlightProgress final : public runner::FlightObserver {
 public:
  FlightProgress(const runner::Scenario& scenario, bool quiet)
      : time_(scenario.time), expected_s_(runner::ExpectedDuration_s(scenario)), progress_(quiet) {}

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult&,
               const runner::FrameRecord& record) override {
    if (!progress_.IsDue()) return;
    const double flown_s = time_.ToSeconds(frame.mid_exposure);
    progress_.Update(
        std::min(flown_s / expected_s_, kNearlyDone),
        fmt::format("{:.1f} s flown, {}, {:.2f} m high", flown_s, Name(record.phase), record.X_WB.translation().z()));
  }

 private:
  static constexpr double kNearlyDone = 0.99;

  models::TimeBase time_;
  double expected_s_;
  Progress progress_;
};

runner::FlightResult FlyWithProgress(const runner::Scenario& scenario, const std::string& out,
                                     const FlyOptions& options) {
  FlightProgress progress(scenario, !options.output.ForPeople());
  runner::FlightObserver* const observers[] = {&progress};
  return FlyIntoFolder(scenario, out, {.video = options.video == "on", .recording = options.record, .bag = options.bag},
                       observers, InterruptRequested);
}

std::vector<runner::Override> OverridesOf(const FlyOptions& options) {
  std::vector<runner::Override> overrides(options.overrides.begin(), options.overrides.end());
  if (options.seed) overrides.emplace_back("seed=" + *options.seed, "--seed " + *options.seed);
  if (options.estimator) {
    overrides.emplace_back("estimator.name=" + config::WriteText(*options.estimator),
                           "--estimator " + *options.estimator);
  }
  return overrides;
}

/// The flight to fly.
struct FlightRequest {
  runner::Scenario scenario;
  std::string log_sha256;  ///< Expected hash of the log; empty if unknown.
};

FlightRequest RequestFromSweep(const std::string& folder, const std::string& id) {
  const auto row = sweeper::SweepStore(folder, sweeper::SweepStore::Access::kRead).Find(id);
  if (!row) throw InputError(fmt::format("{}: contains no flight {}", folder, id));
  return {runner::ParseScenario(row->scenario, id, {}), row->log_sha256};
}

/// Throws InputError when the output directory is the directory of the scenario.
void CheckOutputPath(const std::string& scenario, const std::string& out) {
  namespace fs = std::filesystem;
  if (fs::path(scenario).parent_path() != "" &&
      fs::weakly_canonical(scenario).parent_path() == fs::weakly_canonical(out)) {
    throw InputError(fmt::format("output folder {}: contains the scenario to fly; choose another", out));
  }
}

void WarnIfLogDiffers(const FlightRequest& request, const runner::FlightResult& result) {
  if (request.log_sha256.empty() || request.log_sha256 == result.log_sha256) return;
  spdlog::warn("the log differs from the sweep's: the sweep was flown by another build or on another type of CPU");
}

int FlyWith(const FlyOptions& options) {
  const bool from_sweep = !options.from.empty();
  if (options.scenario.empty() != from_sweep)
    throw InputError("give either SCENARIO or a flight of a sweep, --from DIR ID");
  const FlightRequest request = from_sweep
                                    ? RequestFromSweep(options.from[0], options.from[1])
                                    : FlightRequest{runner::LoadScenario(options.scenario, OverridesOf(options)), ""};
  const runner::Scenario& scenario = request.scenario;
  const std::string out = options.out.value_or("out/" + (from_sweep ? options.from[1] : scenario.name));
  CheckOutputPath(options.scenario, out);
  if (options.junit) util::CheckOutputFile(*options.junit, report::kJunitSignature);
  const runner::FlightResult result = FlyWithProgress(scenario, out, options);
  WarnIfLogDiffers(request, result);
  if (options.junit) {
    const report::JunitSuite suite =
        report::SuiteOf(scenario, result.verdict, result.reason, result.metrics, result.checks);
    util::WriteOutputFile(*options.junit, report::JunitXml({suite}), report::kJunitSignature);
  }
  if (options.output.json) fmt::print("{}", runner::ResultJson(scenario, result));
  if (options.output.ForPeople()) PrintResult(scenario, result, out);
  if (result.verdict == runner::Verdict::kError) spdlog::error("the simulation failed: {}", result.reason);
  switch (result.verdict) {
    case runner::Verdict::kPass:
      return kPassed;
    case runner::Verdict::kFail:
      return kFailed;
    case runner::Verdict::kError:
      break;
  }
  return kInternalError;
}

}  // namespace

void AddFly(CLI::App& app, Run& run) {
  const auto options = std::make_shared<FlyOptions>();
  CLI::App& command = *app.add_subcommand("fly", "Fly a scenario, check its criteria and write its files");
  command.add_option("SCENARIO", options->scenario, "YAML file of the scenario");
  command
      .add_option("--set", options->overrides,
                  "Override a key of the scenario, for example --set camera.noise_sigma=5; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--from", options->from, "Fly the flight with this id of a sweep again; replaces SCENARIO")
      ->type_name("DIR ID")
      ->expected(2)
      ->excludes("--set");
  command.add_option("--seed", options->seed, "Seed of all random sources (default: the scenario's)")
      ->type_name("N")
      ->excludes("--from");
  command.add_option("--estimator", options->estimator, "Name of the estimator (default: the scenario's)")
      ->type_name("NAME")
      ->excludes("--from");
  command.add_option("--out", options->out, "Output directory (default: out/NAME, or out/ID with --from)")
      ->type_name("DIR");
  command.add_option("--video", options->video, "Write a video of the flight, flight.mp4: on (default) or off")
      ->type_name("on|off")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--record", options->record,
                   "Record frames, IMU and truth in EuRoC format, in the subdirectory recording");
  command.add_flag("--bag", options->bag, "Also write the flight as a ROS 1 bag, flight.bag");
  command.add_option("--junit", options->junit, "Write the criteria to this JUnit XML file")->type_name("FILE");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return FlyWith(*options); }; });
}

}  // namespace touchdown::cli
