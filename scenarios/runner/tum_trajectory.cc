#include "scenarios/runner/tum_trajectory.h"

#include <fmt/format.h>

#include <iterator>

namespace touchdown::runner {

std::string TumText(const Trajectory& trajectory, const models::TimeBase& time) {
  std::string text = "# t_s x_m y_m z_m qx qy qz qw\n";
  for (const auto& [tick, X_WB] : trajectory) {
    const Eigen::Vector3d p = X_WB.translation();
    const Eigen::Quaterniond q(X_WB.linear());
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} {}\n", time.ToSeconds(tick), p.x(), p.y(), p.z(),
                   q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

Trajectory TrueTrajectory(const FlightLog& log) {
  Trajectory truth;
  for (const TickRecord& record : log.ticks) truth.emplace(record.truth.tick, record.truth.X_WB);
  for (const FrameRecord& frame : log.frames) truth.emplace(frame.mid_exposure, frame.X_WB);
  for (const auto& record : log.Records<sim::TrackingSystem>()) truth.emplace(record.reading.tick, record.X_WB);
  return truth;
}

Trajectory EstimatedTrajectory(const FlightLog& log) {
  Trajectory estimate;
  for (const FrameRecord& frame : log.frames) {
    if (frame.status != estimator::FrameStatus::kOk) continue;
    estimate.emplace(frame.mid_exposure, frame.pose.value().X_WB);
  }
  return estimate;
}

Trajectory TrackedTrajectory(const FlightLog& log) {
  Trajectory tracked;
  for (const auto& record : log.Records<sim::TrackingSystem>()) {
    tracked.emplace(record.reading.tick, record.reading.X_WB);
  }
  return tracked;
}

}  // namespace touchdown::runner
