#include "scenarios/runner/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/landing_pad.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/pad_view.h"

namespace touchdown::runner {
namespace {

using controller::Phase;
using models::RadToDeg;

constexpr double kExcursion_m = 0.30;
constexpr double kExcursionEnd_m = 0.15;

constexpr MetricInfo kMetrics[] = {
    {"flight.sim_time_s", "s", "Simulated duration of the flight."},
    {"flight.takeoff_time_s", "s", "Time from the start of the blind climb to the first hover phase."},
    {"flight.hover_time_s", "s", "Time in the hover phase."},
    {"flight.hover_xyz_rmse_m", "m", "RMS distance of the true position from the set-point in the hover phase."},
    {"flight.max_xy_offset_m", "m", "Largest true horizontal distance from the set-point in the hover phase."},
    {"flight.excursions", "",
     "Number of times the distance of flight.max_xy_offset_m rose above 0.3 m after being below 0.15 m."},
    {"flight.max_tilt_deg", "deg", "Largest true tilt during the flight."},
    {"flight.landing_time_s", "s", "Time from the start of the landing phase to the first contact of the gear."},
    {"flight.touchdown_time_s", "s", "Simulated time of the first contact of the gear in a landing."},
    {"flight.touchdown_xy_error_m", "m",
     "True horizontal distance from the center of the pad at the first contact of the gear."},
    {"flight.touchdown_x_m", "m", "True X of the body origin in W at the first contact."},
    {"flight.touchdown_y_m", "m", "True Y of the body origin in W at the first contact."},
    {"flight.touchdown_yaw_error_deg", "deg", "Absolute true yaw at the first contact, modulo 180 degrees."},
    {"flight.touchdown_speed_m_s", "m/s", "True sink rate just before the first contact."},
    {"flight.touchdown_tilt_deg", "deg", "True tilt at the first contact."},
    {"flight.rest_xy_error_m", "m", "True horizontal distance from the center of the pad at the end of a landing."},
    {"estimate.xy_rmse_m", "m", "RMS horizontal error of the unfiltered vision position in frames with status ok."},
    {"estimate.z_rmse_m", "m", "RMS vertical error of the unfiltered vision position in frames with status ok."},
    {"estimate.xyz_rmse_m", "m", "RMS 3D error of the unfiltered vision position in frames with status ok."},
    {"estimate.roll_rmse_deg", "deg", "RMS error of the vision roll in frames with status ok."},
    {"estimate.pitch_rmse_deg", "deg", "RMS error of the vision pitch in frames with status ok."},
    {"estimate.yaw_rmse_deg", "deg", "RMS error of the vision yaw, modulo 180 degrees, in frames with status ok."},
    {"estimate.tilt_rmse_deg", "deg",
     "RMS angle between the true and the estimated body Z axis in frames with status ok."},
    {"estimate.availability", "", "Frames with status ok divided by frames with the whole ring in view.", true},
    {"estimate.ring_frames", "", "Number of frames with the whole ring in view."},
    {"estimate.false_pads", "",
     "Number of frames with a detected center of the pad more than 30 px from the true one."},
};

/// Root mean square of the added values. Put adds no metric without values.
class RootMeanSquare {
 public:
  void Add(double squared) {
    sum_ += squared;
    ++count_;
  }
  void Put(Metrics& metrics, std::string_view name) const {
    if (count_ > 0) metrics.emplace(name, std::sqrt(sum_ / static_cast<double>(count_)));
  }

 private:
  double sum_ = 0.0;
  std::int64_t count_ = 0;
};

double Tilt(const Eigen::Matrix3d& R_WB) { return std::acos(std::clamp(R_WB(2, 2), -1.0, 1.0)); }

double Square(double value) { return value * value; }

std::optional<models::Tick> FirstTickIn(const FlightLog& log, Phase phase) {
  const auto found = std::find_if(log.ticks.begin(), log.ticks.end(),
                                  [phase](const TickRecord& record) { return record.control.phase == phase; });
  return found == log.ticks.end() ? std::nullopt : std::optional(found->truth.tick);
}

void PutHover(const FlightLog& log, Metrics& metrics) {
  RootMeanSquare distance;
  double largest = 0.0;
  int excursions = 0;
  bool away = false;
  models::Tick hovering = 0;
  for (std::size_t i = 0; i < log.ticks.size(); ++i) {
    const TickRecord& record = log.ticks[i];
    if (record.control.phase != Phase::kHover) continue;
    if (i > 0) hovering += record.truth.tick - log.ticks[i - 1].truth.tick;
    const Eigen::Vector3d offset = record.truth.X_WB.translation() - record.control.set_point_m;
    distance.Add(offset.squaredNorm());
    const double xy = offset.head<2>().norm();
    largest = std::max(largest, xy);
    if (!away && xy > kExcursion_m) ++excursions;
    away = away ? xy > kExcursionEnd_m : xy > kExcursion_m;
  }
  if (!FirstTickIn(log, Phase::kHover)) return;
  metrics.emplace("flight.hover_time_s", log.time.ToSeconds(hovering));
  distance.Put(metrics, "flight.hover_xyz_rmse_m");
  metrics.emplace("flight.max_xy_offset_m", largest);
  metrics.emplace("flight.excursions", excursions);
}

void PutTouchdown(const FlightLog& log, Metrics& metrics) {
  if (!log.touchdown) return;
  const sim::TrueState& at = log.touchdown->at;
  metrics.emplace("flight.touchdown_time_s", log.time.ToSeconds(at.tick));
  metrics.emplace("flight.touchdown_xy_error_m", at.X_WB.translation().head<2>().norm());
  metrics.emplace("flight.touchdown_x_m", at.X_WB.translation().x());
  metrics.emplace("flight.touchdown_y_m", at.X_WB.translation().y());
  metrics.emplace("flight.touchdown_yaw_error_deg",
                  RadToDeg(std::abs(models::WrapToHalfPi(models::TaitBryanFromRotation(at.X_WB.linear()).yaw))));
  metrics.emplace("flight.touchdown_speed_m_s", -log.touchdown->before.v_WB.z());
  metrics.emplace("flight.touchdown_tilt_deg", RadToDeg(Tilt(at.X_WB.linear())));
  if (const auto begin = FirstTickIn(log, Phase::kLanding)) {
    metrics.emplace("flight.landing_time_s", log.time.ToSeconds(at.tick - *begin));
  }
  if (log.outcome == Outcome::kLanded && !log.ticks.empty()) {
    metrics.emplace("flight.rest_xy_error_m", log.ticks.back().truth.X_WB.translation().head<2>().norm());
  }
}

void PutFlight(const FlightLog& log, Metrics& metrics) {
  metrics.emplace("flight.sim_time_s", log.time.ToSeconds(log.end));
  const auto climb = FirstTickIn(log, Phase::kBlindClimb), hover = FirstTickIn(log, Phase::kHover);
  if (climb && hover) metrics.emplace("flight.takeoff_time_s", log.time.ToSeconds(*hover - *climb));
  double tilt = 0.0;
  for (const TickRecord& record : log.ticks) tilt = std::max(tilt, Tilt(record.truth.X_WB.linear()));
  if (!log.ticks.empty()) metrics.emplace("flight.max_tilt_deg", RadToDeg(tilt));
}

}  // namespace

std::span<const MetricInfo> AllMetrics() { return kMetrics; }

const MetricInfo* FindMetric(std::string_view name) {
  const auto found = std::find_if(std::begin(kMetrics), std::end(kMetrics),
                                  [name](const MetricInfo& info) { return info.name == name; });
  return found == std::end(kMetrics) ? nullptr : found;
}

Metrics PoseErrors(std::span<const FrameRecord> frames) {
  RootMeanSquare xy, z, xyz, roll, pitch, yaw, tilt;
  for (const FrameRecord& frame : frames) {
    if (frame.status != estimator::FrameStatus::kOk) continue;
    const models::TaitBryan truth = models::TaitBryanFromRotation(frame.X_WB.linear());
    const Eigen::Isometry3d X_WB = models::ResolveYawAmbiguity(frame.pose.value().X_WB, truth.yaw);
    const models::TaitBryan angles = models::TaitBryanFromRotation(X_WB.linear());
    const Eigen::Vector3d error = X_WB.translation() - frame.X_WB.translation();
    xy.Add(error.head<2>().squaredNorm());
    z.Add(Square(error.z()));
    xyz.Add(error.squaredNorm());
    roll.Add(Square(RadToDeg(models::WrapToPi(angles.roll - truth.roll))));
    pitch.Add(Square(RadToDeg(angles.pitch - truth.pitch)));
    yaw.Add(Square(RadToDeg(models::WrapToPi(angles.yaw - truth.yaw))));
    tilt.Add(Square(RadToDeg(models::AngleBetween(X_WB.linear().col(2), frame.X_WB.linear().col(2)))));
  }
  Metrics metrics;
  xy.Put(metrics, "estimate.xy_rmse_m");
  z.Put(metrics, "estimate.z_rmse_m");
  xyz.Put(metrics, "estimate.xyz_rmse_m");
  roll.Put(metrics, "estimate.roll_rmse_deg");
  pitch.Put(metrics, "estimate.pitch_rmse_deg");
  yaw.Put(metrics, "estimate.yaw_rmse_deg");
  tilt.Put(metrics, "estimate.tilt_rmse_deg");
  return metrics;
}

Metrics Detection(std::span<const FrameRecord> frames) {
  int in_view = 0, detected = 0, false_pads = 0;
  for (const FrameRecord& frame : frames) {
    if (frame.ring_in_view) ++in_view;
    if (frame.ring_in_view && frame.status == estimator::FrameStatus::kOk) ++detected;
    if (frame.pad_px && (!frame.true_pad_px || (*frame.pad_px - *frame.true_pad_px).norm() > kFalsePad_px)) {
      ++false_pads;
    }
  }
  Metrics metrics;
  if (in_view > 0) metrics.emplace("estimate.availability", static_cast<double>(detected) / in_view);
  metrics.emplace("estimate.ring_frames", in_view);
  metrics.emplace("estimate.false_pads", false_pads);
  return metrics;
}

Metrics ComputeMetrics(const FlightLog& log) {
  Metrics metrics;
  PutFlight(log, metrics);
  PutHover(log, metrics);
  PutTouchdown(log, metrics);
  metrics.merge(PoseErrors(log.frames));
  metrics.merge(Detection(log.frames));
  return metrics;
}

std::string LimitText(const Criterion& criterion) {
  if (criterion.min && criterion.max) return fmt::format("{} .. {}", *criterion.min, *criterion.max);
  return criterion.min ? fmt::format(">= {}", *criterion.min) : fmt::format("<= {}", criterion.max.value());
}

std::vector<Check> Judge(const Scenario& scenario, Outcome outcome, const Metrics& metrics) {
  std::vector<Check> checks;
  checks.push_back({.name = "outcome",
                    .value = {},
                    .text = std::string(Name(outcome)),
                    .unit = "",
                    .limit = std::string(Name(scenario.expected_outcome())),
                    .pass = outcome == scenario.expected_outcome()});
  for (const Criterion& criterion : scenario.criteria) {
    Check check;
    check.name = criterion.metric;
    if (const MetricInfo* const info = FindMetric(criterion.metric)) check.unit = info->unit;
    check.limit = LimitText(criterion);
    if (const auto found = metrics.find(criterion.metric); found != metrics.end()) {
      check.value = found->second;
      check.pass =
          (!criterion.min || *check.value >= *criterion.min) && (!criterion.max || *check.value <= *criterion.max);
    }
    checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace touchdown::runner
