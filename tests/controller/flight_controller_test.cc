#include "controller/flight_controller.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/error.h"
#include "tests/support/flight_rig.h"
#include "tests/support/nominal.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using tests::Fly;
using tests::HoverAt;
using tests::kTime;
using tests::Land;
using tests::RigConfig;
using tests::RigResult;
using tests::TakeoffTo;

models::VehicleEstimate At(double time_s, const Vector3d& p_m) {
  const models::Tick tick = kTime.FromSeconds(time_s);
  models::VehicleEstimate estimate;
  estimate.tick = tick;
  estimate.motion = models::VehicleEstimate::Motion{.p_WB = p_m};
  estimate.pad_seen = tick;
  return estimate;
}

TEST(FlightController, KeepsMotorsOffInStandby) {
  FlightController controller({}, {}, kTime, 200, {TakeoffTo(1.0)}, false);
  EXPECT_EQ(controller.phase(), Phase::kStandby);
  const ControlOutput output = controller.Update({});
  for (const double speed : output.rotors.speed_rad_s) EXPECT_EQ(speed, 0.0);
  EXPECT_EQ(output.thrust_n, 0.0);
}

TEST(FlightController, KeepsStandingTiltInBlindClimb) {
  FlightController controller({}, {}, kTime, 200, {TakeoffTo(1.0)}, false);
  ControlOutput output;
  const models::TaitBryan stance{.roll = 0.02, .pitch = -0.01};
  for (double t = 0.0; t < 2.5; t += 0.005) {
    models::VehicleEstimate estimate;
    estimate.tick = kTime.FromSeconds(t);
    estimate.attitude = stance;
    output = controller.Update(estimate);
  }
  EXPECT_EQ(output.phase, Phase::kBlindClimb);
  EXPECT_NEAR(output.attitude_set_point.roll, stance.roll, 1e-3);
  EXPECT_NEAR(output.attitude_set_point.pitch, stance.pitch, 1e-3);
  EXPECT_GT(output.thrust_n, models::Vehicle{}.mass_kg * models::kGravity_m_s2);
}

TEST(FlightController, HoldsLevelAtHoverThrustBeforeFirstDetection) {
  FlightController controller({}, {}, kTime, 200, {HoverAt({0.0, 0.0, 1.0}, 1.0)}, true);
  const ControlOutput output = controller.Update({});
  EXPECT_EQ(output.phase, Phase::kHold);
  EXPECT_TRUE(output.motion_is_predicted);
  EXPECT_NEAR(output.thrust_n, models::Vehicle{}.mass_kg * models::kGravity_m_s2, 1e-9);
  EXPECT_NEAR(output.torque_n_m.norm(), 0.0, 1e-12);
}

TEST(FlightController, UsesVisionWhileFreshAndPredictionOtherwise) {
  FlightController controller({}, {}, kTime, 200, {HoverAt({0.0, 0.0, 1.0}, 60.0)}, true);
  ControlOutput output;
  for (double t = 0.0; t < 1.0; t += 0.005) output = controller.Update(At(t, {0.1, 0.0, 1.0}));
  EXPECT_FALSE(output.motion_is_predicted);
  EXPECT_EQ(output.motion.p_WB, Vector3d(0.1, 0.0, 1.0));
  models::VehicleEstimate stale = At(1.0, {5.0, 0.0, 1.0});
  stale.pad_seen = kTime.FromSeconds(0.9);
  output = controller.Update(stale);
  EXPECT_TRUE(output.motion_is_predicted);
  EXPECT_NEAR(output.motion.p_WB.x(), 0.1, 0.01);
}

TEST(FlightController, RejectsInvalidConfigurationAndScript) {
  models::Vehicle weak;
  weak.rotor.max_speed_rad_s = 300.0;
  EXPECT_THROW(FlightController({}, weak, kTime, 200, {TakeoffTo(1.0)}, false), InputError);
  EXPECT_THROW(FlightController({}, {}, kTime, 7, {TakeoffTo(1.0)}, false), InputError);
  EXPECT_THROW(FlightController({}, {}, kTime, 200, {}, false), InputError);
  FlightControllerConfig config;
  config.vision_fresh_s = 0.0;
  EXPECT_THROW(FlightController(config, {}, kTime, 200, {TakeoffTo(1.0)}, false), InputError);
}

RigConfig TakeoffHoverLand(std::uint64_t seed) {
  RigConfig config;
  config.seed = seed;
  config.script = {TakeoffTo(1.0), HoverAt({0.0, 0.0, 1.0}, 5.0), Land()};
  return config;
}

TEST(Flight, PassesPhasesInOrderFromTakeoffToLanding) {
  const RigResult result = Fly(TakeoffHoverLand(1));
  const std::vector<Phase> expected{Phase::kStandby, Phase::kBlindClimb,   Phase::kRamp,     Phase::kHover,
                                    Phase::kLanding, Phase::kBlindDescent, Phase::kTouchdown};
  EXPECT_EQ(result.phases, expected);
}

TEST(Flight, GivesUpWithoutPad) {
  RigConfig config = TakeoffHoverLand(1);
  config.events = [](double, tests::QuadrotorOde&) { return false; };
  const RigResult result = Fly(config);
  EXPECT_EQ(result.last_phase, Phase::kGaveUp);
  EXPECT_FALSE(result.crashed);
  EXPECT_LT(result.max_height_m, 4.0);
  EXPECT_LT(result.max_tilt_rad, models::DegToRad(10.0));
}

TEST(Flight, GivesUpIfPadStaysCovered) {
  RigConfig config = TakeoffHoverLand(2);
  config.events = [](double t, tests::QuadrotorOde&) { return t < 7.0; };
  const RigResult result = Fly(config);
  EXPECT_EQ(result.last_phase, Phase::kGaveUp);
  EXPECT_FALSE(result.crashed);
}

TEST(Flight, ContinuesAfterPadIsCoveredTemporarily) {
  RigConfig config = TakeoffHoverLand(3);
  config.events = [](double t, tests::QuadrotorOde&) { return t < 7.0 || t > 8.2; };
  const RigResult result = Fly(config);
  EXPECT_EQ(result.last_phase, Phase::kTouchdown);
  EXPECT_NE(std::find(result.phases.begin(), result.phases.end(), Phase::kHold), result.phases.end());
  ASSERT_TRUE(result.touchdown.has_value());
  EXPECT_LT(result.touchdown->xy_m, 0.06);
}

TEST(Flight, IsBitIdenticalForSameSeed) {
  const RigResult a = Fly(TakeoffHoverLand(4)), b = Fly(TakeoffHoverLand(4)), other = Fly(TakeoffHoverLand(5));
  ASSERT_TRUE(a.touchdown && b.touchdown && other.touchdown);
  EXPECT_EQ(a.touchdown->xy_m, b.touchdown->xy_m);
  EXPECT_EQ(a.hover_rmse_m, b.hover_rmse_m);
  EXPECT_NE(a.touchdown->xy_m, other.touchdown->xy_m);
}

}  // namespace
}  // namespace touchdown::controller
