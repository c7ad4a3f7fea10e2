#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/datasets/pose_score.h"
#include "scenarios/util/version.h"

namespace touchdown::cli {
namespace {

struct ScoreOptions {
  std::string poses, truth;
  OutputOptions output;
};

void PrintScore(const datasets::PoseScore& score) {
  fmt::print("{} poses", score.poses);
  if (score.outside > 0) fmt::print(", and {} outside the time range of the truth", score.outside);
  fmt::print("\n");
  for (const runner::MetricInfo& info : runner::AllMetrics()) {
    const auto found = score.metrics.find(info.name);
    if (found != score.metrics.end()) fmt::print("  {:<24} {:>10.4g} {}\n", info.name, found->second, info.unit);
  }
}

std::string ScoreJson(const datasets::PoseScore& score) {
  nlohmann::ordered_json json;
  json["schema"] = 1;
  json["version"] = util::Version();
  json["poses"] = score.poses;
  json["outside"] = score.outside;
  json["metrics"] = nlohmann::ordered_json::object();
  for (const runner::MetricInfo& info : runner::AllMetrics()) {
    const auto found = score.metrics.find(info.name);
    if (found != score.metrics.end()) json["metrics"][std::string(info.name)] = found->second;
  }
  return json.dump(2) + "\n";
}

int ScoreWith(const ScoreOptions& options) {
  const datasets::PoseScore score = datasets::ScorePoses(datasets::ReadTumFile(options.poses), options.truth);
  if (options.output.json) fmt::print("{}", ScoreJson(score));
  if (options.output.ForPeople()) PrintScore(score);
  return kPassed;
}

}  // namespace

void AddScore(CLI::App& app, Run& run) {
  const auto options = std::make_shared<ScoreOptions>();
  CLI::App& command = *app.add_subcommand("score", "Compare any poses of a flight with its truth, without alignment");
  command.add_option("--poses", options->poses, "Poses of the body in W, in TUM format")->required()->type_name("FILE");
  command.add_option("--truth", options->truth, "Flight directory, or a recording of a flight")
      ->required()
      ->type_name("DIR");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return ScoreWith(*options); }; });
}

}  // namespace touchdown::cli
