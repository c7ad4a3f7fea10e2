#include "scenarios/sweeper/run/failure_phase.h"

#include <algorithm>
#include <map>
#include <vector>

namespace touchdown::sweeper {
namespace {

using controller::Phase;

/// Contribution of frames to a metric of vision: a sum over the frames that grows with each frame that worsens the
/// metric.
double ContributionOf(const std::string& metric, const std::vector<runner::FrameRecord>& frames) {
  const runner::Metrics detection = runner::Detection(frames), errors = runner::PoseErrors(frames);
  const auto value = [](const runner::Metrics& metrics, const std::string& name) {
    const auto found = metrics.find(name);
    return found == metrics.end() ? 0.0 : found->second;
  };
  if (metric == "estimate.false_pads") return value(detection, metric);
  if (metric == "estimate.availability") {
    return (1.0 - value(detection, metric)) * value(detection, "estimate.ring_frames");
  }
  const auto detected = std::count_if(frames.begin(), frames.end(), [](const runner::FrameRecord& frame) {
    return frame.status == estimator::FrameStatus::kOk;
  });
  return value(errors, metric) * value(errors, metric) * static_cast<double>(detected);
}

Phase WorstPhaseOfVision(const std::string& metric, const runner::FlightLog& log) {
  std::map<Phase, std::vector<runner::FrameRecord>> by_phase;
  for (const runner::FrameRecord& frame : log.frames) by_phase[frame.phase].push_back(frame);
  Phase worst = log.frames.back().phase;
  double largest = 0.0;
  for (const auto& [phase, frames] : by_phase) {
    const double contribution = ContributionOf(metric, frames);
    if (contribution <= largest) continue;
    largest = contribution;
    worst = phase;
  }
  return worst;
}

/// Last phase before the guidance gave up; empty if there is none.
std::string LastPhaseFlown(const runner::FlightLog& log) {
  const auto last = std::find_if(log.ticks.rbegin(), log.ticks.rend(),
                                 [](const runner::TickRecord& tick) { return tick.control.phase != Phase::kGaveUp; });
  return last == log.ticks.rend() ? "" : std::string(Name(last->control.phase));
}

}  // namespace

std::string FailurePhase(const runner::Check& check, const runner::FlightLog& log) {
  if (check.name.starts_with("estimate.") && !log.frames.empty()) {
    return std::string(Name(WorstPhaseOfVision(check.name, log)));
  }
  if (check.name.starts_with("flight.touchdown_")) return std::string(Name(Phase::kTouchdown));
  return LastPhaseFlown(log);
}

}  // namespace touchdown::sweeper
