#include "scenarios/runner/fly.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenarios/runner/flight_tables.h"
#include "scenarios/util/platform.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/version.h"

namespace touchdown::runner {
namespace {

constexpr int kResultSchema = 1;

Timing ComputeTiming(const FlightLog& log) {
  std::vector<double> vision_ms, render_ms;
  for (const FrameRecord& frame : log.frames) {
    vision_ms.push_back(frame.vision_ms);
    render_ms.push_back(frame.render_ms);
  }
  Timing timing;
  if (!log.frames.empty()) {
    timing.vision_ms_mean = util::Mean(vision_ms);
    timing.vision_ms_p99 = util::Quantile(vision_ms, 0.99);
    timing.render_ms_mean = util::Mean(render_ms);
  }
  if (log.wall_s > 0.0) timing.realtime_factor = log.time.ToSeconds(log.end) / log.wall_s;
  return timing;
}

nlohmann::ordered_json CheckJson(const Check& check) {
  nlohmann::ordered_json json;
  json["name"] = check.name;
  json["value"] = nullptr;
  if (check.value) json["value"] = *check.value;
  if (!check.text.empty()) json["value"] = check.text;
  json["unit"] = check.unit;
  json["limit"] = check.limit;
  json["pass"] = check.pass;
  return json;
}

}  // namespace

FlightResult JudgeFlight(const Scenario& scenario, const FlightLog& log) {
  FlightResult result;
  result.outcome = log.outcome;
  result.reason = log.reason;
  result.metrics = ComputeMetrics(log);
  result.checks = Judge(scenario, log.outcome, result.metrics);
  const bool passed = std::all_of(result.checks.begin(), result.checks.end(), [](const Check& c) { return c.pass; });
  result.verdict = log.outcome == Outcome::kError ? Verdict::kError : passed ? Verdict::kPass : Verdict::kFail;
  result.timing = ComputeTiming(log);
  result.log_sha256 = LogDigest(log);
  return result;
}

FlightResult Fly(const Scenario& scenario, FlightObservers observers, const util::StopRequested& stop_requested) {
  return JudgeFlight(scenario, FlyClosedLoop(scenario, observers, stop_requested));
}

std::string ResultJson(const Scenario& scenario, const FlightResult& result) {
  nlohmann::ordered_json json;
  json["schema"] = kResultSchema;
  json["version"] = util::Version();
  json["scenario"] = scenario.name;
  json["seed"] = scenario.seed;
  json["estimator"] = scenario.estimator.name;
  json["outcome"] = Name(result.outcome);
  json["reason"] = result.reason;
  json["verdict"] = Name(result.verdict);
  json["checks"] = nlohmann::ordered_json::array();
  for (const Check& check : result.checks) json["checks"].push_back(CheckJson(check));
  json["metrics"] = nlohmann::ordered_json::object();
  for (const MetricInfo& info : AllMetrics()) {
    if (const auto found = result.metrics.find(info.name); found != result.metrics.end()) {
      json["metrics"][std::string(info.name)] = found->second;
    }
  }
  json["log_sha256"] = result.log_sha256;
  for (const auto& [name, value] : util::PlatformFacts()) json["platform"][name] = value;
  return json.dump(2) + "\n";
}

std::string TimingJson(const Timing& timing) {
  nlohmann::ordered_json json;
  json["vision_ms_mean"] = timing.vision_ms_mean;
  json["vision_ms_p99"] = timing.vision_ms_p99;
  json["render_ms_mean"] = timing.render_ms_mean;
  json["realtime_factor"] = timing.realtime_factor;
  return json.dump(2) + "\n";
}

}  // namespace touchdown::runner
