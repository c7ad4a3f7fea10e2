#include "tests/support/synthetic_flight.h"

#include <algorithm>
#include <cmath>

#include "scenarios/runner/flight_tables.h"
#include "scenarios/runner/fly.h"

namespace touchdown::tests {
namespace {

using controller::Phase;
using runner::FlightLog;
using runner::FrameRecord;
using runner::Scenario;
using runner::TickRecord;

constexpr models::Tick kImuPeriod = 6;
constexpr models::Tick kCameraPeriod = 20;

Phase PhaseAt(double fraction) {
  if (fraction < 0.1) return Phase::kStandby;
  if (fraction < 0.2) return Phase::kBlindClimb;
  if (fraction < 0.8) return Phase::kHover;
  return fraction < 0.9 ? Phase::kLanding : Phase::kTouchdown;
}

Eigen::Isometry3d PoseAt(double fraction) {
  const bool on_the_ground = fraction < 0.1 || fraction >= 0.9;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << 0.1 * std::sin(20.0 * fraction), 0.05, on_the_ground ? 0.14 : 1.0;
  return X_WB;
}

}  // namespace

FlightLog SyntheticFlight(const Scenario& scenario, double duration_s) {
  FlightLog log;
  log.time = scenario.time;
  log.end = scenario.time.FromSeconds(duration_s);
  log.outcome = runner::Outcome::kLanded;
  log.wall_s = 1.0;
  const auto fraction = [&log](models::Tick tick) { return static_cast<double>(tick) / static_cast<double>(log.end); };
  for (models::Tick tick = 0; tick <= log.end; tick += kImuPeriod) {
    TickRecord& record = log.ticks.emplace_back();
    record.truth.tick = tick;
    record.truth.X_WB = PoseAt(fraction(tick));
    record.truth.gear_in_contact = record.truth.X_WB.translation().z() < 0.5;
    record.control.phase = PhaseAt(fraction(tick));
    record.control.set_point_m << 0.0, 0.0, 1.0;
    if (record.control.phase != Phase::kHover) continue;
    record.estimate.motion = models::VehicleEstimate::Motion();
    record.estimate.motion->p_WB = record.truth.X_WB.translation();
  }
  const auto contact = std::find_if(log.ticks.begin(), log.ticks.end(),
                                    [](const TickRecord& record) { return record.control.phase == Phase::kTouchdown; });
  log.touchdown = FlightLog::FirstContact{(contact - 1)->truth, contact->truth};
  for (models::Tick tick = 0; tick <= log.end; tick += kCameraPeriod) {
    FrameRecord& frame = log.frames.emplace_back();
    frame.mid_exposure = frame.delivered = tick;
    frame.X_WB = PoseAt(fraction(tick));
    frame.phase = PhaseAt(fraction(tick));
    frame.vision_ms = 2.0;
    if (frame.phase != Phase::kHover) continue;
    frame.status = estimator::FrameStatus::kOk;
    frame.pose.emplace();
    frame.pose->X_WB = frame.X_WB;
  }
  return log;
}

report::FlightFiles FilesOf(const Scenario& scenario, const FlightLog& log) {
  const runner::FlightResult result = runner::JudgeFlight(scenario, log);
  report::FlightFiles files;
  files.folder = "flight";
  files.result_json = ResultJson(scenario, result);
  files.scenario_yaml = ScenarioYaml(scenario);
  files.flight_csv = runner::FlightCsv(log);
  files.frames_csv = runner::FramesCsv(log);
  files.frame_timing_csv = runner::FrameTimingCsv(log);
  files.timing_json = TimingJson(result.timing);
  return files;
}

}  // namespace touchdown::tests
