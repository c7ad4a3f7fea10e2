#include "scenarios/runner/closed_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "models/angles.h"
#include "scenarios/util/stopwatch.h"

namespace touchdown::runner {
namespace {

using Eigen::Vector3d;

/// Largest angle between the true and the estimated vertical, rad.
double LargestLevelError(const FlightLog& log) {
  double largest = 0.0;
  for (const TickRecord& tick : log.ticks) {
    const Vector3d truth = tick.truth.X_WB.linear().row(2);
    const Vector3d estimate = models::RotationFromTaitBryan(tick.estimate.attitude).row(2);
    largest = std::max(largest, std::atan2(truth.cross(estimate).norm(), truth.dot(estimate)));
  }
  return largest;
}

TEST(ClosedLoop, KnowsImuBiasesAtAirborneStart) {
  for (const std::uint64_t seed : {1u, 2u}) {
    Scenario scenario;
    scenario.seed = seed;
    scenario.start = {.airborne = true, .position_m = {0.2, -0.1, 1.0}, .yaw_deg = 17.0};
    scenario.script = {{.kind = controller::ManeuverKind::kHover, .position_m = {0.0, 0.0, 1.0}, .duration_s = 60.0}};
    scenario.time_limit_s = 0.25;
    scenario.world.paint_textures = false;  // Roll and pitch do not depend on the pad.
    scenario.vehicle.imu.misalignment_deg = {.roll = 1.7, .pitch = -1.1, .yaw = 2.3};
    const FlightLog log = FlyClosedLoop(scenario, {}, nullptr);
    ASSERT_GT(log.ticks.size(), 45u);
    EXPECT_EQ(log.ticks.front().estimate.tick, 0);
    EXPECT_LT(LargestLevelError(log), models::DegToRad(0.3)) << seed;
  }
}

Scenario HandHeld(std::uint64_t seed) {
  Scenario scenario;
  scenario.seed = seed;
  scenario.hand = {.carries = true, .duration_s = 10.0};
  scenario.camera.rate_hz = 10;
  return scenario;
}

TEST(ClosedLoop, TracksHandHeldVehicle) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const FlightLog log = FlyClosedLoop(HandHeld(seed), {}, nullptr);
    EXPECT_EQ(log.outcome, Outcome::kHovered) << log.reason;
    EXPECT_LT(LargestLevelError(log), models::DegToRad(4.0)) << seed;  // The hand accelerates.
    int detected = 0, in_view = 0;
    for (const FrameRecord& frame : log.frames) {
      in_view += frame.ring_in_view ? 1 : 0;
      if (frame.status != estimator::FrameStatus::kOk) continue;
      // If the H is strongly foreshortened, the yaw error also rotates the position about the pad.
      const Vector3d found = frame.pose->X_WB.translation(), truth = frame.X_WB.translation();
      EXPECT_NEAR(found.z(), truth.z(), 0.03);
      EXPECT_NEAR(found.head<2>().norm(), truth.head<2>().norm(), 0.10);
      ++detected;
    }
    EXPECT_GT(in_view, 40) << seed;  // The pad leaves the view occasionally, because of the tilt.
    EXPECT_GT(detected, 0.9 * in_view) << seed;
    for (const TickRecord& tick : log.ticks) EXPECT_EQ(tick.control.rotors.speed_rad_s[0], 0.0);
  }
}

/// Stores the IMU samples before the flight.
class StandingImu final : public FlightObserver {
 public:
  void OnImu(const models::ImuSample& sample, bool /*at_rest*/) override {
    if (sample.tick >= 0) return;
    sum_ += sample.specific_force_U;
    ++count_;
  }
  Vector3d mean() const { return sum_ / count_; }

 private:
  Vector3d sum_ = Vector3d::Zero();
  int count_ = 0;
};

TEST(ClosedLoop, RestsOnSlopeWithInitialHeadingBeforeAirborneStart) {
  Scenario scenario;
  scenario.start = {.airborne = true, .yaw_deg = 90.0};
  scenario.script = {{.kind = controller::ManeuverKind::kHover, .position_m = {0.0, 0.0, 1.0}, .duration_s = 60.0}};
  scenario.time_limit_s = 0.1;
  scenario.world.paint_textures = false;
  scenario.world.ground_tilt.roll_deg = 5.7;  // Lower towards -Y of W, which lies behind the vehicle.
  scenario.imu.accelerometer_bias_sigma_m_s2 = 0.0;
  StandingImu imu;
  FlightObserver* const observers[] = {&imu};
  FlyClosedLoop(scenario, observers, nullptr);
  const Vector3d expected = models::kGravity_m_s2 * Vector3d(std::sin(0.1), 0.0, std::cos(0.1));
  EXPECT_LT((imu.mean() - expected).norm(), 0.01) << imu.mean().transpose();
}

/// Observer that sleeps in each call.
class SlowObserver final : public FlightObserver {
 public:
  void OnStart(const sim::World& world) override { started_ = world.state().tick == 0; }
  void OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) override {
    EXPECT_TRUE(started_);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++count_;
  }
  double slept_s() const { return 0.02 * count_; }

 private:
  bool started_ = false;
  int count_ = 0;
};

TEST(ClosedLoop, ExcludesObserversFromWallTime) {
  Scenario scenario;
  scenario.script = {{.kind = controller::ManeuverKind::kTakeoff}};
  scenario.time_limit_s = 0.5;
  scenario.world.paint_textures = false;
  SlowObserver observer;
  FlightObserver* const observers[] = {&observer};
  const util::Stopwatch clock;
  const FlightLog log = FlyClosedLoop(scenario, observers, nullptr);
  EXPECT_GT(observer.slept_s(), 1.9);
  EXPECT_GT(log.wall_s, 0.0);
  EXPECT_LE(log.wall_s, clock.seconds() - observer.slept_s());
}

}  // namespace
}  // namespace touchdown::runner
