#include "scenarios/runner/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "models/angles.h"
#include "scenarios/runner/flight_log.h"

namespace touchdown::runner {
namespace {

using controller::Phase;
using estimator::FrameStatus;
using models::DegToRad;

Eigen::Isometry3d Pose(double x, double y, double z, const models::TaitBryan& angles = {}) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan(angles);
  X_WB.translation() << x, y, z;
  return X_WB;
}

/// Consecutive IMU ticks at 200 Hz.
void AddTicks(FlightLog& log, int count, Phase phase, const Eigen::Isometry3d& X_WB) {
  for (int i = 0; i < count; ++i) {
    TickRecord record;
    record.truth.tick = static_cast<models::Tick>(log.ticks.size()) * 6;
    record.truth.X_WB = X_WB;
    record.control.phase = phase;
    record.control.set_point_m << 0.0, 0.0, 1.0;
    log.ticks.push_back(record);
    log.end = record.truth.tick;
  }
}

FrameRecord Frame(const Eigen::Isometry3d& truth, const Eigen::Isometry3d& estimate) {
  FrameRecord frame;
  frame.status = FrameStatus::kOk;
  frame.X_WB = truth;
  frame.pose.emplace().X_WB = estimate;
  frame.ring_in_view = true;
  return frame;
}

TEST(Metrics, OmitUndefinedMetrics) {
  const Metrics metrics = ComputeMetrics(FlightLog());
  EXPECT_FALSE(metrics.contains("flight.touchdown_xy_error_m"));
  EXPECT_FALSE(metrics.contains("flight.hover_xyz_rmse_m"));
  EXPECT_FALSE(metrics.contains("estimate.xy_rmse_m"));
  EXPECT_FALSE(metrics.contains("estimate.availability"));
  EXPECT_TRUE(metrics.contains("flight.sim_time_s"));
}

TEST(Metrics, HaveUniqueNames) {
  std::set<std::string_view> names;
  for (const MetricInfo& info : AllMetrics()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(FindMetric(info.name), &info);
  }
  EXPECT_EQ(FindMetric("flight.beauty"), nullptr);
}

TEST(Metrics, CompareVisionWithTruth) {
  FlightLog log;
  log.frames.push_back(Frame(Pose(0.1, 0.2, 1.0), Pose(0.13, 0.24, 1.0, {DegToRad(1), DegToRad(-2), DegToRad(3)})));
  log.frames.push_back(Frame(Pose(0, 0, 1.0), Pose(0, 0, 1.02)));
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_NEAR(metrics.at("estimate.xy_rmse_m"), 0.05 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(metrics.at("estimate.z_rmse_m"), 0.02 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(metrics.at("estimate.xyz_rmse_m"), std::sqrt((0.0025 + 0.0004) / 2.0), 1e-12);
  EXPECT_NEAR(metrics.at("estimate.roll_rmse_deg"), 1.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(metrics.at("estimate.pitch_rmse_deg"), 2.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(metrics.at("estimate.yaw_rmse_deg"), 3.0 / std::sqrt(2.0), 1e-9);
  const double tilt = std::acos(std::cos(DegToRad(1)) * std::cos(DegToRad(2)));
  EXPECT_NEAR(metrics.at("estimate.tilt_rmse_deg"), models::RadToDeg(tilt) / std::sqrt(2.0), 1e-9);
}

TEST(Metrics, IgnoreRotationBy180Degrees) {
  const models::TaitBryan truth{DegToRad(5), DegToRad(-3), DegToRad(88)};
  const models::TaitBryan turned{DegToRad(5), DegToRad(-3), DegToRad(-90)};
  FlightLog log;
  log.frames.push_back(Frame(Pose(0.3, 0.1, 1.0, truth), Pose(-0.3, -0.1, 1.0, turned)));
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_NEAR(metrics.at("estimate.xyz_rmse_m"), 0.0, 1e-12);
  EXPECT_NEAR(metrics.at("estimate.roll_rmse_deg"), 0.0, 1e-9);
  EXPECT_NEAR(metrics.at("estimate.yaw_rmse_deg"), 2.0, 1e-9);
}

TEST(Metrics, IgnorePoseErrorsOfFramesThatAreNotOk) {
  FlightLog log;
  log.frames.push_back(Frame(Pose(0, 0, 1), Pose(0, 0, 1.01)));
  log.frames.push_back(Frame(Pose(0, 0, 1), Pose(5, 5, 5)));
  log.frames.back().status = FrameStatus::kRejected;
  EXPECT_NEAR(ComputeMetrics(log).at("estimate.xyz_rmse_m"), 0.01, 1e-12);
}

TEST(Metrics, ComputeAvailabilityFromFramesWithWholeRing) {
  FlightLog log;
  for (int i = 0; i < 3; ++i) log.frames.push_back(Frame(Pose(0, 0, 1), Pose(0, 0, 1)));
  log.frames.push_back(Frame(Pose(0, 0, 1), Pose(0, 0, 1)));
  log.frames.back().status = FrameStatus::kNotFound;
  log.frames.push_back(Frame(Pose(0, 0, 0.1), Pose(0, 0, 0.1)));
  log.frames.back().status = FrameStatus::kNotFound;
  log.frames.back().ring_in_view = false;
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_DOUBLE_EQ(metrics.at("estimate.availability"), 0.75);
  EXPECT_EQ(metrics.at("estimate.ring_frames"), 4.0);
}

TEST(Metrics, CountFalsePadsBeyondThirtyPixels) {
  FlightLog log;
  const auto add = [&log](const std::optional<Eigen::Vector2d>& seen, const std::optional<Eigen::Vector2d>& truth) {
    FrameRecord frame;
    frame.pad_px = seen;
    frame.true_pad_px = truth;
    log.frames.push_back(frame);
  };
  add(Eigen::Vector2d(100, 100), Eigen::Vector2d(118, 124));  // Exactly 30 px, so not a false pad.
  add(std::nullopt, Eigen::Vector2d(300, 300));
  add(Eigen::Vector2d(100, 100), Eigen::Vector2d(118, 125));
  add(Eigen::Vector2d(100, 100), std::nullopt);  // No pad is visible.
  EXPECT_EQ(ComputeMetrics(log).at("estimate.false_pads"), 2.0);
}

TEST(Metrics, CompareHoverWithSetPoint) {
  FlightLog log;
  AddTicks(log, 10, Phase::kRamp, Pose(9, 9, 9));
  AddTicks(log, 100, Phase::kHover, Pose(0.3, 0.4, 1.0));
  AddTicks(log, 100, Phase::kHover, Pose(0, 0, 1.1));
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_NEAR(metrics.at("flight.hover_xyz_rmse_m"), std::sqrt((0.25 + 0.01) / 2.0), 1e-12);
  EXPECT_NEAR(metrics.at("flight.max_xy_offset_m"), 0.5, 1e-12);
  EXPECT_NEAR(metrics.at("flight.hover_time_s"), 1.0, 1e-9);
}

TEST(Metrics, CountExcursionOnceUntilVehicleReturns) {
  FlightLog log;
  for (const double x : {0.0, 0.31, 0.29, 0.32, 0.14, 0.35, 0.0, 0.299}) AddTicks(log, 3, Phase::kHover, Pose(x, 0, 1));
  EXPECT_EQ(ComputeMetrics(log).at("flight.excursions"), 2.0);
}

TEST(Metrics, MeasureDurationsOfPhases) {
  FlightLog log;
  AddTicks(log, 200, Phase::kStandby, Pose(0, 0, 0.14));
  AddTicks(log, 400, Phase::kBlindClimb, Pose(0, 0, 0.3));
  AddTicks(log, 600, Phase::kRamp, Pose(0, 0, 0.6));
  AddTicks(log, 200, Phase::kHover, Pose(0, 0, 1.0));
  AddTicks(log, 300, Phase::kLanding, Pose(0, 0, 0.5, {DegToRad(4), 0, 0}));
  log.touchdown = FlightLog::FirstContact{log.ticks.back().truth, log.ticks.back().truth};
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_NEAR(metrics.at("flight.takeoff_time_s"), 5.0, 1e-9);
  EXPECT_NEAR(metrics.at("flight.landing_time_s"), 299.0 / 200.0, 1e-9);
  EXPECT_NEAR(metrics.at("flight.sim_time_s"), 1699.0 / 200.0, 1e-9);
  EXPECT_NEAR(metrics.at("flight.max_tilt_deg"), 4.0, 1e-9);
}

TEST(Metrics, MeasureTouchdownAtFirstContact) {
  FlightLog log;
  AddTicks(log, 10, Phase::kTouchdown, Pose(0.05, 0, 0.14));
  log.outcome = Outcome::kLanded;
  FlightLog::FirstContact contact;
  contact.before.v_WB << 0.3, 0.0, -0.25;
  contact.at.v_WB << 0.1, 0.0, 0.02;
  contact.at.X_WB = Pose(0.03, -0.04, 0.14, {DegToRad(3), DegToRad(-4), DegToRad(-178)});
  log.touchdown = contact;
  const Metrics metrics = ComputeMetrics(log);
  EXPECT_NEAR(metrics.at("flight.touchdown_xy_error_m"), 0.05, 1e-12);
  EXPECT_NEAR(metrics.at("flight.touchdown_speed_m_s"), 0.25, 1e-12);
  EXPECT_NEAR(metrics.at("flight.touchdown_yaw_error_deg"), 2.0, 1e-9);
  EXPECT_NEAR(metrics.at("flight.touchdown_tilt_deg"), 4.9985, 1e-3);
  EXPECT_NEAR(metrics.at("flight.rest_xy_error_m"), 0.05, 1e-12);
}

TEST(Judge, FailsUndefinedMetric) {
  Scenario scenario;
  scenario.expect = Outcome::kLanded;
  scenario.criteria.push_back({.metric = "flight.touchdown_xy_error_m", .min = {}, .max = 0.06});
  const std::vector<Check> checks = Judge(scenario, Outcome::kLanded, {});
  ASSERT_EQ(checks.size(), 2u);
  EXPECT_TRUE(checks[0].pass);
  EXPECT_FALSE(checks[1].pass);
  EXPECT_FALSE(checks[1].value.has_value());
}

TEST(Judge, IncludesBounds) {
  Scenario scenario;
  scenario.criteria.push_back({.metric = "flight.sim_time_s", .min = 2.0, .max = 3.0});
  const auto passes = [&scenario](double value) {
    return Judge(scenario, Outcome::kLanded, {{"flight.sim_time_s", value}})[1].pass;
  };
  EXPECT_TRUE(passes(2.0));
  EXPECT_TRUE(passes(3.0));
  EXPECT_FALSE(passes(1.999));
  EXPECT_FALSE(passes(3.001));
}

TEST(Judge, ComparesOutcomeWithExpectedOne) {
  Scenario scenario;
  scenario.expect = Outcome::kGaveUp;
  EXPECT_TRUE(Judge(scenario, Outcome::kGaveUp, {})[0].pass);
  const Check check = Judge(scenario, Outcome::kLanded, {})[0];
  EXPECT_FALSE(check.pass);
  EXPECT_EQ(check.text, "landed");
  EXPECT_EQ(check.limit, "gave_up");
}

}  // namespace
}  // namespace touchdown::runner
