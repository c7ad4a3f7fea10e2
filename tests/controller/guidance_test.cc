#include "controller/guidance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/error.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;

constexpr double kPeriod_s = 0.005, kStanding_m = 0.14;
const GuidanceConfig kConfig;
const models::TimeBase kTime;
const double kBlindHeight_m = kStanding_m + kConfig.blind_clearance_m;

const Manoeuvre kTakeoff{.kind = ManoeuvreKind::kTakeoff, .position_m = {0.0, 0.0, 1.0}};
const Manoeuvre kHover{.kind = ManoeuvreKind::kHover, .position_m = {0.1, 0.2, 1.0}, .duration_s = 2.0};
const Manoeuvre kLand{.kind = ManoeuvreKind::kLand};

/// Guidance with a vehicle that does what the test says, period by period.
class Flight {
 public:
  Flight(std::vector<Manoeuvre> script, bool airborne)
      : guidance_(kConfig, kTime, kPeriod_s, kStanding_m, std::move(script), airborne) {
    p = {0.0, 0.0, airborne ? 1.5 : kStanding_m};
  }

  Vector3d p, v = Vector3d::Zero();
  bool pad_lost = false, pad_found = true;
  bool follows = false;  ///< The vehicle is always at the set-point.
  Guidance::Output output;
  double time_s = 0.0;

  const Guidance::Output& Step() {
    output = guidance_.Update(
        {.tick = tick_, .motion = {.p_WB = p, .v_WB = v}, .pad_lost = pad_lost, .pad_found = pad_found});
    if (follows) p = output.p_m;
    tick_ += kTime.FromSeconds(kPeriod_s);
    time_s = kTime.ToSeconds(tick_);
    return output;
  }
  void Run(double duration_s) {
    for (int i = 0; i < std::lround(duration_s / kPeriod_s); ++i) Step();
  }
  bool RunUntil(Phase phase, double limit_s) {
    for (int i = 0; i * kPeriod_s < limit_s; ++i) {
      if (Step().phase == phase) return true;
    }
    return false;
  }
  void LosePad() { pad_lost = true, pad_found = false; }
  void FindPad() { pad_lost = false, pad_found = true; }

 private:
  Guidance guidance_;
  models::Tick tick_ = 0;
};

TEST(Guidance, FliesAScriptFromStandbyToTouchdown) {
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

TEST(Guidance, RaisesTheThrustInTheBlindClimbUpToItsLimit) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  EXPECT_NEAR(flight.output.thrust_ratio, kConfig.start_thrust_ratio, 0.01);
  flight.Run(1.0);
  EXPECT_NEAR(flight.output.thrust_ratio, kConfig.start_thrust_ratio + kConfig.thrust_ratio_rate_1_s, 0.01);
  flight.Run(2.5);
  EXPECT_DOUBLE_EQ(flight.output.thrust_ratio, kConfig.max_thrust_ratio);
}

TEST(Guidance, ClimbsBlindUpToTheVisionFloorThoughThePadIsSeen) {
  Flight flight({kTakeoff}, false);
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = kStanding_m + 0.9 * kConfig.vision_floor_clearance_m;
  EXPECT_EQ(flight.Step().phase, Phase::kBlindClimb);
  flight.p.z() = kStanding_m + 1.1 * kConfig.vision_floor_clearance_m;
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
}

TEST(Guidance, StopsTheBlindClimbAtItsHeight) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = kStanding_m + 0.99 * kConfig.blind_climb_limit_m;
  EXPECT_EQ(flight.Step().phase, Phase::kBlindClimb);
  flight.p.z() = kStanding_m + 1.01 * kConfig.blind_climb_limit_m;
  EXPECT_EQ(flight.Step().phase, Phase::kHold);
  EXPECT_EQ(flight.output.p_m, flight.p);  // Never saw the pad: it holds where it thinks it is.
}

TEST(Guidance, RampsUpAtAConstantRate) {
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
  flight.Run(2.0);  // The set-point has arrived, the vehicle has not.
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.0);
  EXPECT_EQ(flight.output.v_m_s, Vector3d::Zero());
  flight.p.z() = 1.0 - 0.9 * kConfig.arrival_error_m;
  EXPECT_EQ(flight.Step().phase, Phase::kHover);
}

TEST(Guidance, HoversForAsLongAsTheScriptSaysNotCountingLosses) {
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

TEST(Guidance, SaysWhenAScriptThatEndsInTheAirIsDone) {
  Flight flight({kHover}, true);
  flight.Run(1.9);
  EXPECT_FALSE(flight.output.script_done);
  flight.Run(0.2);
  EXPECT_TRUE(flight.output.script_done);
  EXPECT_EQ(flight.output.phase, Phase::kHover);
  EXPECT_EQ(flight.output.p_m, kHover.position_m);
}

TEST(Guidance, StartsInTheAirInAHoldUntilThePadIsFound) {
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

TEST(Guidance, StepsDownOnlyAfterT0InTheCone) {
  Flight flight({kLand}, true);
  const double cone_m = kConfig.cone_radius_m + (1.5 - kBlindHeight_m) * std::tan(kConfig.cone_half_angle_rad);
  flight.p.x() = 1.02 * cone_m;
  flight.Run(2.0);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.p.x() = 0.98 * cone_m;
  flight.Run(kConfig.t_0_s - 0.01);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.Run(0.03);
  EXPECT_LT(flight.output.p_m.z(), 1.5);
  flight.Run(1.0);  // Not following: the height error keeps it from taking the next step.
  EXPECT_NEAR(flight.output.p_m.z(), 1.5 - kConfig.h_step_m, 1e-9);
}

TEST(Guidance, WaitsForTheHeightErrorBeforeItSteps) {
  Flight flight({kLand}, true);
  flight.Step();
  flight.p.z() = 1.5 + 1.05 * kConfig.h_err_m;
  flight.Run(2.0);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
  flight.p.z() = 1.5 + 0.95 * kConfig.h_err_m;
  flight.Run(kConfig.t_0_s + 0.02);
  EXPECT_LT(flight.output.p_m.z(), 1.5);
}

TEST(Guidance, StartsTheWaitOverWhenTheConeIsLeft) {
  Flight flight({kLand}, true);
  flight.Run(0.8 * kConfig.t_0_s);
  flight.p.x() = 1.0;
  flight.Step();
  flight.p.x() = 0.0;
  flight.Run(0.8 * kConfig.t_0_s);
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), 1.5);
}

TEST(Guidance, NarrowsTheConeTowardsThePad) {
  Flight flight({kLand}, true);
  flight.follows = true;
  flight.Run(0.5);
  flight.follows = false;
  // Follows in height, at an offset that only the upper part of Q' allows.
  const double offset_m = kConfig.cone_radius_m + 0.5 * std::tan(kConfig.cone_half_angle_rad);
  for (int i = 0; i < 4000; ++i) {
    flight.p = {offset_m, 0.0, flight.output.p_m.z()};
    flight.Step();
  }
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_NEAR(flight.output.p_m.z(), kBlindHeight_m + 0.5, kConfig.h_step_m);
}

TEST(Guidance, DescendsBlindOnlyWhenSlow) {
  Flight flight({kLand}, true);
  flight.follows = true;
  flight.v = {1.1 * kConfig.blind_entry_speed_m_s, 0.0, 0.0};
  flight.Run(10.0);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_NEAR(flight.output.p_m.z(), kBlindHeight_m, 1e-9);
  flight.v.setZero();
  EXPECT_EQ(flight.Step().phase, Phase::kBlindDescent);
}

TEST(Guidance, DescendsBlindAtAConstantRateWithOrWithoutThePad) {
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

TEST(Guidance, StopsTheMotorsOfABlindDescentThatTakesTooLong) {
  Flight flight({kLand}, true);
  flight.follows = true;
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindDescent, 15.0));
  flight.follows = false;
  EXPECT_TRUE(flight.RunUntil(Phase::kTouchdown, 2.0));
}

TEST(Guidance, HoldsThenClimbsThenGivesUpWithoutThePad) {
  Flight flight({kHover}, true);
  flight.p.z() = 1.0;
  flight.Run(0.5);
  flight.LosePad();
  EXPECT_EQ(flight.Step().phase, Phase::kHold);
  ASSERT_TRUE(flight.RunUntil(Phase::kSearchClimb, kConfig.hold_limit_s + 0.1));
  flight.Run(1.0);
  EXPECT_NEAR(flight.output.p_m.z(), 1.0 + kConfig.search_climb_rate_m_s, 0.01);
  EXPECT_EQ(flight.output.p_m.head<2>(), kHover.position_m.head<2>());
  ASSERT_TRUE(flight.RunUntil(Phase::kGaveUp, kConfig.search_climb_limit_s));
  flight.FindPad();
  flight.Run(1.0);
  EXPECT_EQ(flight.output.phase, Phase::kGaveUp);
}

TEST(Guidance, GivesUpWhenItHasClimbedFarEnoughFromAnyHeight) {
  for (const double height_m : {0.5, 1.0, 4.0}) {
    Flight flight({kHover}, true);
    flight.p.z() = height_m;
    flight.Run(0.5);
    flight.LosePad();
    ASSERT_TRUE(flight.RunUntil(Phase::kSearchClimb, 2.0));
    flight.p.z() = height_m + kConfig.search_climb_m - 0.01;
    EXPECT_EQ(flight.Step().phase, Phase::kSearchClimb) << height_m;
    flight.p.z() = height_m + kConfig.search_climb_m + 0.01;
    EXPECT_EQ(flight.Step().phase, Phase::kGaveUp) << height_m;
  }
}

TEST(Guidance, GivesUpALandingThatTakesTooLong) {
  Flight flight({kLand}, true);
  flight.p = {1.0, 0.0, 1.0};  // Outside the cone, for good.
  ASSERT_TRUE(flight.RunUntil(Phase::kLanding, 1.0));
  flight.Run(kConfig.landing_limit_s - 1.0);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_TRUE(flight.RunUntil(Phase::kGaveUp, 1.5));
}

TEST(Guidance, RestartsALandingFromTheHeightWhereThePadIsFoundAgain) {
  Flight flight({kLand}, true);
  flight.follows = true;
  flight.Run(2.0);
  flight.follows = false;
  ASSERT_EQ(flight.output.phase, Phase::kLanding);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kSearchClimb, 2.0));
  flight.p = {0.2, 0.1, 1.3};
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kLanding);
  EXPECT_EQ(flight.output.p_m, Vector3d(0.0, 0.0, 1.3));
}

/// A takeoff that has reached the ramp, the vehicle at 0.35 m.
Flight OnTheRamp() {
  Flight flight({kTakeoff, kLand}, false);
  flight.LosePad();
  EXPECT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = 0.35;
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
  return flight;
}

TEST(Guidance, HoldsWhenABlindClimbThatStaysLowTakesTooLong) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.Run(kConfig.blind_climb_limit_s - 0.05);
  EXPECT_EQ(flight.output.phase, Phase::kBlindClimb);
  EXPECT_TRUE(flight.RunUntil(Phase::kHold, 0.1));
}

TEST(Guidance, GivesUpARampThatNeverArrives) {
  Flight flight = OnTheRamp();
  flight.Run(kConfig.ramp_limit_s - 0.05);
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  EXPECT_TRUE(flight.RunUntil(Phase::kGaveUp, 0.1));
}

TEST(Guidance, HoldsTheRampsSetPointWhileThePadIsLostAndGoesOnFromTheVehiclesHeight) {
  Flight flight = OnTheRamp();
  flight.Run(1.0);
  const Vector3d set_point = flight.output.p_m;
  flight.LosePad();
  EXPECT_EQ(flight.Step().phase, Phase::kHold);
  flight.Run(0.3);
  EXPECT_EQ(flight.output.p_m, set_point);
  EXPECT_EQ(flight.output.v_m_s, Vector3d::Zero());
  flight.p = {0.1, 0.0, 0.55};
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
  EXPECT_EQ(flight.output.p_m.head<2>(), Eigen::Vector2d::Zero());
  EXPECT_NEAR(flight.output.p_m.z(), 0.55, kConfig.climb_rate_m_s * kPeriod_s + 1e-12);
}

TEST(Guidance, GoesFromTheSearchBackToTheRampOfAnUnfinishedTakeoff) {
  Flight flight = OnTheRamp();
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kSearchClimb, kConfig.hold_limit_s + 0.1));
  flight.p = {0.0, 0.2, 0.8};
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
  flight.follows = true;
  ASSERT_TRUE(flight.RunUntil(Phase::kHover, 2.0));
  EXPECT_DOUBLE_EQ(flight.output.p_m.z(), kTakeoff.position_m.z());
  EXPECT_EQ(flight.Step().phase, Phase::kLanding);
}

TEST(Guidance, GoesFromTheSearchBackToTheHoversSetPoint) {
  Flight flight({kHover, kLand}, true);
  flight.p = kHover.position_m;
  flight.Run(0.5);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kSearchClimb, 2.0));
  flight.Run(1.0);
  EXPECT_GT(flight.output.p_m.z(), kHover.position_m.z());
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kHover);
  EXPECT_EQ(flight.output.p_m, kHover.position_m);
  flight.Run(1.45);
  EXPECT_EQ(flight.output.phase, Phase::kHover);
  flight.Run(0.1);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
}

TEST(Guidance, RefusesAScriptThatCannotBeFlown) {
  const auto make = [](std::vector<Manoeuvre> script, bool airborne) {
    Guidance(kConfig, kTime, kPeriod_s, kStanding_m, std::move(script), airborne);
  };
  EXPECT_NO_THROW(make({kTakeoff, kHover, kHover, kLand}, false));
  EXPECT_NO_THROW(make({kLand}, true));
  EXPECT_THROW(make({}, false), InputError);
  EXPECT_THROW(make({kHover}, false), InputError);
  EXPECT_THROW(make({kTakeoff}, true), InputError);
  EXPECT_THROW(make({kTakeoff, kTakeoff}, false), InputError);
  EXPECT_THROW(make({kTakeoff, kLand, kHover}, false), InputError);
  Manoeuvre buried = kHover;
  buried.position_m.z() = 0.5 * kBlindHeight_m;
  EXPECT_THROW(make({buried}, true), InputError);
  Manoeuvre nowhere = kHover;
  nowhere.position_m.x() = NAN;
  EXPECT_THROW(make({nowhere}, true), InputError);
  Manoeuvre backwards = kHover;
  backwards.duration_s = -1.0;
  EXPECT_THROW(make({backwards}, true), InputError);
}

TEST(GuidanceConfig, RefusesNumbersThatContradictEachOther) {
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
  refuses([](GuidanceConfig& c) { c.cone_half_angle_rad = 1.6; });
}

}  // namespace
}  // namespace touchdown::controller
