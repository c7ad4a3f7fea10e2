#include "scenarios/cli/fly.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/progress_line.h"
#include "scenarios/flight/config_writer.h"
#include "scenarios/flight/scenario.h"
#include "scenarios/report/flight_folder.h"

namespace touchdown::scenarios {
namespace {

struct Options {
  std::string scenario;
  std::vector<std::string> overrides;
  std::optional<std::string> seed;
  std::optional<std::string> estimator;
  std::optional<std::string> out;
  std::string video = "on";
};

void PrintVerdict(const FlightResult& result) {
  for (const Check& check : result.checks) {
    const std::string value = check.value ? fmt::format("{:.4g}", *check.value) : check.text;
    fmt::print("  {}  {:<32} {:>10} {:<4} {}\n", check.pass ? "pass" : "FAIL", check.name,
               value.empty() ? "none" : value, check.unit, check.limit);
  }
  fmt::print("{} ({}): {}\n", Name(result.outcome), result.reason, Name(result.verdict));
}

/// Tells how far the flight is.
class FlightProgress final : public FlightObserver {
 public:
  explicit FlightProgress(const models::TimeBase& time) : time_(time) {}

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameEstimate&, const FrameRecord& record) override {
    if (!line_.IsDue()) return;
    line_.Show(fmt::format("{:.1f} s flown, {}, {:.2f} m high", time_.ToSeconds(frame.mid_exposure), Name(record.phase),
                           record.X_WB.translation().z()));
  }

 private:
  models::TimeBase time_;
  ProgressLine line_;
};

FlightResult FlyWithProgress(const Scenario& scenario, const std::string& out, const FlightExtras& extras) {
  FlightProgress progress(scenario.time);
  FlightObserver* const observers[] = {&progress};
  return FlyIntoFolder(scenario, out, extras, observers, InterruptRequested);
}

std::vector<Override> OverridesOf(const Options& options) {
  std::vector<Override> overrides(options.overrides.begin(), options.overrides.end());
  if (options.seed) overrides.emplace_back("seed=" + *options.seed, "--seed " + *options.seed);
  if (options.estimator) {
    overrides.emplace_back("estimator.name=" + WriteText(*options.estimator), "--estimator " + *options.estimator);
  }
  return overrides;
}

int FlyWith(const Options& options) {
  const Scenario scenario = LoadScenario(options.scenario, OverridesOf(options));
  const std::string out = options.out.value_or("out/" + scenario.name);
  if (std::filesystem::path(options.scenario).parent_path() != "" &&
      std::filesystem::weakly_canonical(options.scenario).parent_path() == std::filesystem::weakly_canonical(out)) {
    throw InputError(fmt::format("output folder {}: holds the scenario that is flown; name another", out));
  }
  const FlightResult result = FlyWithProgress(scenario, out, {.video = options.video == "on"});
  fmt::print("{}, seed {}, estimator {}\n", scenario.name, scenario.seed, scenario.estimator.name);
  PrintVerdict(result);
  fmt::print("{:.1f} s flown at {:.2f} times real time, vision {:.1f} ms a frame; files in {}\n",
             result.metrics.at("flight.sim_time_s"), result.timing.realtime_factor, result.timing.vision_ms_mean, out);
  if (result.verdict == Verdict::kError) spdlog::error("the simulation went wrong: {}", result.reason);
  switch (result.verdict) {
    case Verdict::kPass:
      return kPassed;
    case Verdict::kFail:
      return kFailed;
    case Verdict::kError:
      break;
  }
  return kInternalError;
}

}  // namespace

void AddFly(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("fly", "Fly a scenario, judge it, and leave its files");
  command.add_option("SCENARIO", options->scenario, "The scenario's YAML file")->required();
  command.add_option("--set", options->overrides, "Change a key of the scenario, as in --set camera.noise_sigma=5")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", options->seed, "Seed of every random source (default: the scenario's)")->type_name("N");
  command.add_option("--estimator", options->estimator, "Name of the estimator (default: the scenario's)")
      ->type_name("NAME");
  command.add_option("--out", options->out, "Folder for the files (default: out/NAME)")->type_name("DIR");
  command
      .add_option("--video", options->video, "Whether to leave a film of the flight, flight.mp4: on (default) or off")
      ->type_name("on|off")
      ->check(CLI::IsMember({"on", "off"}));
  command.callback([options, &run] { run = [options] { return FlyWith(*options); }; });
}

}  // namespace touchdown::scenarios
