#include "scenarios/cli/fly.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/flight_folder.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output.h"
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
  std::vector<std::string> from;  ///< A sweep's folder and a flight's id.
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
  fmt::print("{:.1f} s flown at {:.2f} times real time, vision {:.1f} ms a frame; files in {}\n",
             result.metrics.at("flight.sim_time_s"), result.timing.realtime_factor, result.timing.vision_ms_mean, out);
}

/// Tells how far the flight is.
class FlightProgress final : public runner::FlightObserver {
 public:
  FlightProgress(const runner::Scenario& scenario, bool quiet)
      : time_(scenario.time), expected_s_(runner::ExpectedDuration_s(scenario)), progress_(quiet) {}

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult&,
               const runner::FrameRecord& record) override {
    if (!progress_.IsDue()) return;
    const double flown_s = time_.ToSeconds(frame.mid_exposure);
    progress_.Tell(
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

/// What is to be flown, and the log that it should leave, when that is known.
struct Order {
  runner::Scenario scenario;
  std::string log_sha256;
};

Order OrderFrom(const std::string& folder, const std::string& id) {
  const auto row = sweeper::SweepStore(folder, sweeper::SweepStore::Access::kRead).Find(id);
  if (!row) throw InputError(fmt::format("{}: has no flight {}", folder, id));
  return {runner::ParseScenario(row->scenario, id, {}), row->log_sha256};
}

/// A scenario's folder is not the place for what is made of it.
void CheckPlace(const std::string& scenario, const std::string& out) {
  namespace fs = std::filesystem;
  if (fs::path(scenario).parent_path() != "" &&
      fs::weakly_canonical(scenario).parent_path() == fs::weakly_canonical(out)) {
    throw InputError(fmt::format("output folder {}: holds the scenario that is flown; name another", out));
  }
}

void PrintWhetherSame(const Order& order, const runner::FlightResult& result) {
  if (order.log_sha256.empty() || order.log_sha256 == result.log_sha256) return;
  spdlog::warn("the log is not the sweep's: it was flown by another build, or on another type of CPU");
}

int FlyWith(const FlyOptions& options) {
  const bool is_again = !options.from.empty();
  if (options.scenario.empty() != is_again)
    throw InputError("name either a SCENARIO or a sweep's flight, --from DIR ID");
  const Order order = is_again ? OrderFrom(options.from[0], options.from[1])
                               : Order{runner::LoadScenario(options.scenario, OverridesOf(options)), ""};
  const runner::Scenario& scenario = order.scenario;
  const std::string out = options.out.value_or("out/" + (is_again ? options.from[1] : scenario.name));
  CheckPlace(options.scenario, out);
  if (options.junit) util::CheckOutputFile(*options.junit, report::kJunitSignature);
  const runner::FlightResult result = FlyWithProgress(scenario, out, options);
  PrintWhetherSame(order, result);
  if (options.junit) {
    const report::JunitSuite suite =
        report::SuiteOf(scenario, result.verdict, result.reason, result.metrics, result.checks);
    util::WriteOutputFile(*options.junit, report::JunitXml({suite}), report::kJunitSignature);
  }
  if (options.output.json) fmt::print("{}", runner::ResultJson(scenario, result));
  if (options.output.ForPeople()) PrintResult(scenario, result, out);
  if (result.verdict == runner::Verdict::kError) spdlog::error("the simulation went wrong: {}", result.reason);
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
  CLI::App& command = *app.add_subcommand("fly", "Fly a scenario, judge it, and leave its files");
  command.add_option("SCENARIO", options->scenario, "The scenario's YAML file");
  command.add_option("--set", options->overrides, "Change a key of the scenario, as in --set camera.noise_sigma=5")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--from", options->from, "In place of SCENARIO: a flight of a sweep, flown again")
      ->type_name("DIR ID")
      ->expected(2)
      ->excludes("--set");
  command.add_option("--seed", options->seed, "Seed of every random source (default: the scenario's)")
      ->type_name("N")
      ->excludes("--from");
  command.add_option("--estimator", options->estimator, "Name of the estimator (default: the scenario's)")
      ->type_name("NAME")
      ->excludes("--from");
  command.add_option("--out", options->out, "Folder for the files (default: out/NAME)")->type_name("DIR");
  command
      .add_option("--video", options->video, "Whether to leave a film of the flight, flight.mp4: on (default) or off")
      ->type_name("on|off")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--record", options->record,
                   "Record frames, IMU and truth in EuRoC's layout, in the folder recording");
  command.add_flag("--bag", options->bag, "Leave the flight as a ROS 1 bag too, flight.bag");
  command.add_option("--junit", options->junit, "File for the criteria as JUnit XML")->type_name("FILE");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return FlyWith(*options); }; });
}

}  // namespace touchdown::cli
