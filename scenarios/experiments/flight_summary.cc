#include "scenarios/experiments/flight_summary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "models/angles.h"
#include "models/pose_interpolation.h"
#include "scenarios/experiments/shadow_estimator.h"
#include "scenarios/experiments/shipped_flights.h"
#include "scenarios/report/published.h"
#include "scenarios/runner/closed_loop.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::experiments {
namespace {

using models::RadToDeg;

double Rounded(double value, double step) { return std::round(value / step) * step; }

/// Errors of the frames in mm and deg, by the keys of kTableOne.
Json ErrorsJson(std::span<const runner::FrameRecord> frames) {
  const runner::Metrics errors = runner::PoseErrors(frames);
  Json json = Json::object();
  for (const report::TableOneRow& row : report::kTableOne) {
    if (const auto found = errors.find(row.metric); found != errors.end()) {
      json[std::string(row.key)] = found->second * row.scale;
    }
  }
  return json;
}

using TrackingRecord = runner::SensorRecord<sim::TrackingSystem>;

/// Pose of the tracking system at a tick, interpolated between the poses before and after; nullopt in its gaps.
std::optional<Eigen::Isometry3d> TrackedAt(std::span<const TrackingRecord> tracking, models::Tick tick,
                                           models::Tick period) {
  const auto after = std::lower_bound(tracking.begin(), tracking.end(), tick,
                                      [](const TrackingRecord& r, models::Tick t) { return r.reading.tick < t; });
  if (after == tracking.end()) return std::nullopt;
  if (after->reading.tick == tick) return after->reading.X_WB;
  if (after == tracking.begin()) return std::nullopt;
  const models::TrackedPose &a = (after - 1)->reading, &b = after->reading;
  if (b.tick - a.tick > period) return std::nullopt;
  const double fraction = static_cast<double>(tick - a.tick) / static_cast<double>(b.tick - a.tick);
  return models::InterpolatePose(a.X_WB, b.X_WB, fraction);
}

/// The frames with the pose of the tracking system instead of the truth, without the frames in its gaps.
std::vector<runner::FrameRecord> WithTrackingAsTruth(std::span<const runner::FrameRecord> frames,
                                                     std::span<const TrackingRecord> tracking, models::Tick period) {
  std::vector<runner::FrameRecord> result;
  for (runner::FrameRecord frame : frames) {
    const auto tracked = TrackedAt(tracking, frame.mid_exposure, period);
    if (!tracked) continue;
    frame.X_WB = *tracked;
    result.push_back(std::move(frame));
  }
  return result;
}

/// Appends x, y, z in m and roll, pitch, yaw in deg to a row, or six nulls for nullopt.
void AppendPose(Json& row, const std::optional<Eigen::Isometry3d>& X_WB) {
  if (!X_WB) {
    for (int i = 0; i < 6; ++i) row.push_back(nullptr);
    return;
  }
  constexpr double kStep_m = 1e-5, kStep_deg = 1e-3;
  const models::TaitBryan angles = models::TaitBryanFromRotation(X_WB->linear());
  for (int i = 0; i < 3; ++i) row.push_back(Rounded(X_WB->translation()[i], kStep_m));
  for (const double angle : {angles.roll, angles.pitch, angles.yaw}) row.push_back(Rounded(RadToDeg(angle), kStep_deg));
}

/// At most kMaxRows rows of time, true pose, tracked pose and vision pose.
Json SeriesJson(const runner::FlightLog& log, models::Tick tracking_period) {
  constexpr std::size_t kMaxRows = 700;
  const std::size_t stride = 1 + log.frames.size() / kMaxRows;
  Json rows = Json::array();
  for (std::size_t i = 0; i < log.frames.size(); i += stride) {
    const runner::FrameRecord& frame = log.frames[i];
    Json row = Json::array({Rounded(log.time.ToSeconds(frame.mid_exposure), 1e-4)});
    AppendPose(row, frame.X_WB);
    AppendPose(row, TrackedAt(log.Records<sim::TrackingSystem>(), frame.mid_exposure, tracking_period));
    std::optional<Eigen::Isometry3d> vision;
    if (frame.status == estimator::FrameStatus::kOk) {
      vision =
          models::ResolveYawAmbiguity(frame.pose.value().X_WB, models::TaitBryanFromRotation(frame.X_WB.linear()).yaw);
    }
    AppendPose(row, vision);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Deviations of the vehicle at the end of the flight from the pad's center and heading.
Json RestJson(const runner::FlightLog& log) {
  const Eigen::Isometry3d& X_WB = log.ticks.back().truth.X_WB;
  return {{"x_mm", 1e3 * X_WB.translation().x()},
          {"y_mm", 1e3 * X_WB.translation().y()},
          {"yaw_deg", RadToDeg(models::WrapToHalfPi(models::TaitBryanFromRotation(X_WB.linear()).yaw))}};
}

}  // namespace

runner::Scenario ShippedFlight(const std::string& name, std::uint64_t seed, const std::vector<std::string>& set) {
  std::vector<runner::Override> overrides(set.begin(), set.end());
  overrides.emplace_back("seed=" + std::to_string(seed));
  for (const auto& [flight, yaml] : ShippedFlights()) {
    if (flight == name) return runner::ParseScenario(std::string(yaml), name + ".yaml", {}, overrides);
  }
  throw std::logic_error("unknown flight " + name);
}

Json FlyAndSummarize(const runner::Scenario& scenario, const FlightSummaryOptions& options,
                     const util::StopRequested& stop_requested) {
  std::optional<ShadowEstimator> integer_points, unverified;
  std::vector<runner::FlightObserver*> observers;
  if (options.integer_contours) {
    estimator::EstimatorConfig config = scenario.estimator;
    config.paper.contour_points = estimator::pad::ContourPoints::kInteger;
    observers.push_back(&integer_points.emplace(scenario, config));
  }
  if (options.unverified) {
    estimator::EstimatorConfig config = scenario.estimator;
    config.paper.verify = estimator::paper::Verify::kNone;
    observers.push_back(&unverified.emplace(scenario, config));
  }
  const runner::FlightLog log = runner::FlyClosedLoop(scenario, observers, stop_requested);
  if (log.outcome == runner::Outcome::kError) throw std::runtime_error(scenario.name + ": " + log.reason);

  const models::Tick tracking_period =
      scenario.time.PeriodOf(std::get<sim::TrackingSystemConfig>(scenario.sensors).rate_hz);
  const runner::Metrics metrics = runner::ComputeMetrics(log);
  const std::vector<runner::Check> checks = runner::Judge(scenario, log.outcome, metrics);
  Json json{
      {"seed", scenario.seed},
      {"outcome", Name(log.outcome)},
      {"as_expected", log.outcome == scenario.expected_outcome()},
      {"passed", std::all_of(checks.begin(), checks.end(), [](const runner::Check& check) { return check.pass; })},
      {"truth", ErrorsJson(log.frames)},
      {"tracking", ErrorsJson(WithTrackingAsTruth(log.frames, log.Records<sim::TrackingSystem>(), tracking_period))}};
  if (integer_points) json["integer"] = ErrorsJson(integer_points->frames());
  if (unverified) {
    json["unverified"] = ErrorsJson(unverified->frames());
    const runner::Metrics detection = runner::Detection(unverified->frames());
    for (const char* name : {"estimate.availability", "estimate.false_pads"}) {
      if (const auto found = detection.find(name); found != detection.end()) json["unverified"][name] = found->second;
    }
  }
  for (const char* name :
       {"estimate.availability", "estimate.false_pads", "estimate.ring_frames", "flight.max_tilt_deg",
        "flight.sim_time_s", "flight.max_xy_offset_m", "flight.touchdown_xy_error_m", "flight.touchdown_speed_m_s"}) {
    if (const auto found = metrics.find(name); found != metrics.end()) json[name] = found->second;
  }
  double height_m = 0.0;
  for (const runner::TickRecord& tick : log.ticks) height_m = std::max(height_m, tick.truth.X_WB.translation().z());
  json["max_height_m"] = height_m;
  if (log.outcome == runner::Outcome::kLanded) json["rest"] = RestJson(log);
  if (options.series) json["series"] = SeriesJson(log, tracking_period);
  return json;
}

}  // namespace touchdown::experiments
