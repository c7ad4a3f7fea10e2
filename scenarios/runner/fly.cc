#include "scenarios/runner/fly.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/runner/flight_tables.h"
#include "scenarios/util/platform.h"
#include "scenarios/util/sha256.h"
#include "scenarios/util/version.h"

namespace touchdown::runner {
namespace {

constexpr int kResultSchema = 1;

Timing ComputeTiming(const FlightLog& log) {
  Timing timing;
  std::vector<double> vision_ms;
  for (const FrameRecord& frame : log.frames) {
    vision_ms.push_back(frame.vision_ms);
    timing.vision_ms_mean += frame.vision_ms;
    timing.render_ms_mean += frame.render_ms;
  }
  if (!vision_ms.empty()) {
    const auto count = static_cast<double>(vision_ms.size());
    timing.vision_ms_mean /= count;
    timing.render_ms_mean /= count;
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * count)) - 1;
    std::nth_element(vision_ms.begin(), vision_ms.begin() + static_cast<std::ptrdiff_t>(rank), vision_ms.end());
    timing.vision_ms_p99 = vision_ms[rank];
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

std::string_view Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kError:
      break;
  }
  return "error";
}

FlightResult JudgeFlight(const Scenario& scenario, const FlightLog& log) {
  FlightResult result;
  result.outcome = log.outcome;
  result.reason = log.reason;
  result.metrics = ComputeMetrics(log);
  result.checks = Judge(scenario, log.outcome, result.metrics);
  const bool passed = std::all_of(result.checks.begin(), result.checks.end(), [](const Check& c) { return c.pass; });
  result.verdict = log.outcome == Outcome::kError ? Verdict::kError : passed ? Verdict::kPass : Verdict::kFail;
  result.timing = ComputeTiming(log);
  result.truth = TrueTrajectory(log);
  result.tracked = TrackedTrajectory(log);
  result.tables = {.flight_csv = FlightCsv(log),
                   .frames_csv = FramesCsv(log),
                   .tracking_csv = TrackingCsv(log),
                   .frame_timing_csv = FrameTimingCsv(log),
                   .truth_tum = TumText(result.truth, log.time),
                   .estimate_tum = TumText(EstimatedTrajectory(log), log.time),
                   .tracking_tum = TumText(result.tracked, log.time)};
  result.log_sha256 = util::Sha256({&result.tables.flight_csv, &result.tables.frames_csv});
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
