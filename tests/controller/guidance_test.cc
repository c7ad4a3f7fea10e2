#include "controller/guidance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/error.h"
#include "tests/support/guided_flight.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using tests::kBlindHeight_m;
using tests::kConfig;
using tests::kHover;
using tests::kLand;
using tests::kPeriod_s;
using tests::kStanding_m;
using tests::kTakeoff;
using tests::kTime;
using Flight = tests::GuidedFlight;

TEST(Guidance, FliesScriptFromStandbyToTouchdown) {
  Flight flight({kTakeoff, kHover, kLand}, false);
  flight.LosePad();
  flight.Step();
  EXPECT_EQ(flight.output.phase, Phase::kStandby);
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, kConfig.standby_s + 0.1));
  EXPECT_NEAR(flight.time_s, kConfig.standby_s, 0.02);
  flight.p.z() = 0.3;
  flight.FindPad();
  flight.follows = true;
  flight.Step();
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  ASSERT_TRUE(flight.RunUntil(Phase::kHover, 5.0));
  ASSERT_TRUE(flight.RunUntil(Phase::kLanding, 5.0));
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindDescent, 10.0));
  EXPECT_FALSE(flight.output.script_done);
  ASSERT_TRUE(flight.RunUntil(Phase::kTouchdown, 2.0));
  EXPECT_TRUE(flight.output.script_done);
  flight.Run(5.0);
  EXPECT_EQ(flight.output.phase, Phase::kTouchdown);
}

TEST(Guidance, RaisesThrustToLimitInBlindClimb) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  EXPECT_NEAR(flight.output.thrust_ratio, kConfig.start_thrust_ratio, 0.01);
  flight.Run(1.0);
  EXPECT_NEAR(flight.output.thrust_ratio, kConfig.start_thrust_ratio + kConfig.thrust_ratio_rate_1_s, 0.01);
  flight.Run(2.5);
  EXPECT_DOUBLE_EQ(flight.output.thrust_ratio, kConfig.max_thrust_ratio);
}

TEST(Guidance, ClimbsBlindToVisionFloorEvenWithPadInView) {
  Flight flight({kTakeoff}, false);
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = kStanding_m + 0.9 * kConfig.vision_floor_clearance_m;
  EXPECT_EQ(flight.Step().phase, Phase::kBlindClimb);
  flight.p.z() = kStanding_m + 1.1 * kConfig.vision_floor_clearance_m;
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
}

TEST(Guidance, StopsBlindClimbAtHeightLimit) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = kStanding_m + 0.99 * kConfig.blind_climb_limit_m;
  EXPECT_EQ(flight.Step().phase, Phase::kBlindClimb);
  flight.p.z() = kStanding_m + 1.01 * kConfig.blind_climb_limit_m;
  EXPECT_EQ(flight.Step().phase, Phase::kHold);
  EXPECT_EQ(flight.output.p_m, flight.p);  // Without a detection, it holds its predicted position.
}

TEST(Guidance, RampsUpAtConstantRate) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p = {0.05, -0.03, 0.35};
  flight.FindPad();
  flight.Step();
  flight.Run(1.0);
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  EXPECT_NEAR(flight.output.p_m.z(), 0.35 + kConfig.climb_rate_m_s, 0.01);
  EXPECT_DOUBLE_EQ(flight.output.v_m_s.z(), kConfig.climb_rate_m_s);
  EXPECT_EQ(flight.output.p_m.head<2>(), Eigen::Vector2d::Zero());
  flight.Run(2.0);  // The set-point has reached the height, but the vehicle has not.
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.0);
  EXPECT_EQ(flight.output.v_m_s, Vector3d::Zero());
  flight.p.z() = 1.0 - 0.9 * kConfig.arrival_error_m;
  EXPECT_EQ(flight.Step().phase, Phase::kHover);
}

TEST(Guidance, ExcludesLossesFromHoverDuration) {
  Flight flight({kHover, kLand}, true);
  flight.Run(1.0);
  EXPECT_EQ(flight.output.phase, Phase::kHover);
  EXPECT_EQ(flight.output.p_m, kHover.position_m);
  flight.LosePad();
  flight.Run(0.5);
  EXPECT_EQ(flight.output.phase, Phase::kHold);
  EXPECT_EQ(flight.output.p_m, kHover.position_m);
  flight.FindPad();
  flight.Run(0.9);
  EXPECT_EQ(flight.output.phase, Phase::kHover);
  flight.Run(0.15);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
}

TEST(Guidance, ReportsEndOfScriptInTheAir) {
  Flight flight({kHover}, true);
  flight.Run(1.9);
  EXPECT_FALSE(flight.output.script_done);
  flight.Run(0.2);
  EXPECT_TRUE(flight.output.script_done);
  EXPECT_EQ(flight.output.phase, Phase::kHover);
  EXPECT_EQ(flight.output.p_m, kHover.position_m);
}

TEST(Guidance, HoldsAfterAirborneStartUntilPadIsFound) {
  Flight flight({kLand}, true);
  flight.LosePad();
  flight.p.setZero();
  EXPECT_EQ(flight.Step().phase, Phase::kHold);
  EXPECT_EQ(flight.output.p_m, Vector3d::Zero());
  flight.Run(0.1);
  flight.FindPad();
  flight.p = {0.3, 0.0, 1.5};
  EXPECT_EQ(flight.Step().phase, Phase::kLanding);
  EXPECT_EQ(flight.output.p_m, Vector3d(0.0, 0.0, 1.5));
}

TEST(Guidance, StepsDownAfterT0InCone) {
  Flight flight({kLand}, true);
  const double cone_m =
      kConfig.cone_radius_m + (1.5 - kBlindHeight_m) * std::tan(models::DegToRad(kConfig.cone_half_angle_deg));
  flight.p.x() = 1.02 * cone_m;
  flight.Run(2.0);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.p.x() = 0.98 * cone_m;
  flight.Run(kConfig.t_0_s - 0.01);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.Run(0.03);
  EXPECT_LT(flight.output.p_m.z(), 1.5);
  flight.Run(1.0);  // The vehicle does not follow, so the height error prevents the next step.
  EXPECT_NEAR(flight.output.p_m.z(), 1.5 - kConfig.h_step_m, 1e-9);
}

TEST(Guidance, WaitsForHeightErrorBeforeStep) {
  Flight flight({kLand}, true);
  flight.Step();
  flight.p.z() = 1.5 + 1.05 * kConfig.h_err_m;
  flight.Run(2.0);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.p.z() = 1.5 + 0.95 * kConfig.h_err_m;
  flight.Run(kConfig.t_0_s + 0.02);
  EXPECT_LT(flight.output.p_m.z(), 1.5);
}

TEST(Guidance, RestartsWaitWhenVehicleLeavesCone) {
  Flight flight({kLand}, true);
  flight.Run(0.8 * kConfig.t_0_s);
  flight.p.x() = 1.0;
  flight.Step();
  flight.p.x() = 0.0;
  flight.Run(0.8 * kConfig.t_0_s);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
}

TEST(Guidance, NarrowsConeTowardsPad) {
  Flight flight({kLand}, true);
  flight.follows = true;
  flight.Run(0.5);
  flight.follows = false;
  // The vehicle follows in height, with an offset that only the upper part of Q' allows.
  const double offset_m = kConfig.cone_radius_m + 0.5 * std::tan(models::DegToRad(kConfig.cone_half_angle_deg));
  for (int i = 0; i < 4000; ++i) {
    flight.p = {offset_m, 0.0, flight.output.p_m.z()};
    flight.Step();
  }
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_NEAR(flight.output.p_m.z(), kBlindHeight_m + 0.5, kConfig.h_step_m);
}

TEST(Guidance, BeginsBlindDescentOnlyAtLowSpeed) {
  Flight flight({kLand}, true);
  flight.follows = true;
  flight.v = {1.1 * kConfig.blind_entry_speed_m_s, 0.0, 0.0};
  flight.Run(10.0);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_NEAR(flight.output.p_m.z(), kBlindHeight_m, 1e-9);
  flight.v.setZero();
  EXPECT_EQ(flight.Step().phase, Phase::kBlindDescent);
}

TEST(Guidance, DescendsBlindAtConstantRateWithAndWithoutPad) {
  for (const bool seen : {true, false}) {
    Flight flight({kLand}, true);
    flight.follows = true;
    ASSERT_TRUE(flight.RunUntil(Phase::kBlindDescent, 15.0));
    if (!seen) flight.LosePad();
    const double begin_s = flight.time_s;
    const double way_m = flight.p.z() - kStanding_m - kConfig.h_land_clearance_m;
    ASSERT_TRUE(flight.RunUntil(Phase::kTouchdown, 5.0));
    EXPECT_NEAR(flight.time_s - begin_s, way_m / kConfig.blind_descent_rate_m_s, 0.03);
  }
}

TEST(Guidance, RejectsInvalidScript) {
  const auto make = [](std::vector<Maneuver> script, bool airborne) {
    Guidance(kConfig, kTime, kPeriod_s, kStanding_m, std::move(script), airborne);
  };
  EXPECT_NO_THROW(make({kTakeoff, kHover, kHover, kLand}, false));
  EXPECT_NO_THROW(make({kLand}, true));
  EXPECT_THROW(make({}, false), InputError);
  EXPECT_THROW(make({kHover}, false), InputError);
  EXPECT_THROW(make({kTakeoff}, true), InputError);
  EXPECT_THROW(make({kTakeoff, kTakeoff}, false), InputError);
  EXPECT_THROW(make({kTakeoff, kLand, kHover}, false), InputError);
  Maneuver buried = kHover;
  buried.position_m.z() = 0.5 * kBlindHeight_m;
  EXPECT_THROW(make({buried}, true), InputError);
  Maneuver nowhere = kHover;
  nowhere.position_m.x() = NAN;
  EXPECT_THROW(make({nowhere}, true), InputError);
  Maneuver backwards = kHover;
  backwards.duration_s = -1.0;
  EXPECT_THROW(make({backwards}, true), InputError);
}

TEST(GuidanceConfig, RejectsContradictoryValues) {
  EXPECT_NO_THROW(GuidanceConfig{}.Validate());
  const auto refuses = [](const std::function<void(GuidanceConfig&)>& change) {
    GuidanceConfig config;
    change(config);
    EXPECT_THROW(config.Validate(), InputError);
  };
  refuses([](GuidanceConfig& c) { c.h_step_m = 0.0; });
  refuses([](GuidanceConfig& c) { c.climb_rate_m_s = NAN; });
  refuses([](GuidanceConfig& c) { c.hold_limit_s = -1.0; });
  refuses([](GuidanceConfig& c) { c.h_land_clearance_m = c.blind_clearance_m; });
  refuses([](GuidanceConfig& c) { c.vision_floor_clearance_m = c.blind_clearance_m + 0.01; });
  refuses([](GuidanceConfig& c) { c.max_thrust_ratio = c.start_thrust_ratio - 0.1; });
  refuses([](GuidanceConfig& c) { c.cone_half_angle_deg = 91.0; });
}

}  // namespace
}  // namespace touchdown::controller
