#include "controller/guidance.h"

#include <gtest/gtest.h>

#include "tests/support/guided_flight.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using tests::kConfig;
using tests::kHover;
using tests::kLand;
using tests::kPeriod_s;
using tests::kTakeoff;
using Flight = tests::GuidedFlight;

TEST(Guidance, StopsMotorsWhenBlindDescentTimesOut) {
  Flight flight({kLand}, true);
  flight.follows = true;
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindDescent, 15.0));
  flight.follows = false;
  EXPECT_TRUE(flight.RunUntil(Phase::kTouchdown, 2.0));
}

TEST(Guidance, HoldsThenClimbsThenGivesUpWithoutPad) {
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

TEST(Guidance, GivesUpAtLimitOfSearchClimbFromAnyHeight) {
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

TEST(Guidance, GivesUpWhenLandingTimesOut) {
  Flight flight({kLand}, true);
  flight.p = {1.0, 0.0, 1.0};  // Outside the cone until the end.
  ASSERT_TRUE(flight.RunUntil(Phase::kLanding, 1.0));
  flight.Run(kConfig.landing_limit_s - 1.0);
  EXPECT_EQ(flight.output.phase, Phase::kLanding);
  EXPECT_TRUE(flight.RunUntil(Phase::kGaveUp, 1.5));
}

TEST(Guidance, RestartsLandingAtHeightWherePadIsFoundAgain) {
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

/// Takeoff in the ramp phase with the vehicle at 0.35 m.
Flight OnTheRamp() {
  Flight flight({kTakeoff, kLand}, false);
  flight.LosePad();
  EXPECT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.p.z() = 0.35;
  flight.FindPad();
  EXPECT_EQ(flight.Step().phase, Phase::kRamp);
  return flight;
}

TEST(Guidance, HoldsWhenBlindClimbTimesOut) {
  Flight flight({kTakeoff}, false);
  flight.LosePad();
  ASSERT_TRUE(flight.RunUntil(Phase::kBlindClimb, 2.0));
  flight.Run(kConfig.blind_climb_limit_s - 0.05);
  EXPECT_EQ(flight.output.phase, Phase::kBlindClimb);
  EXPECT_TRUE(flight.RunUntil(Phase::kHold, 0.1));
}

TEST(Guidance, GivesUpWhenRampTimesOut) {
  Flight flight = OnTheRamp();
  flight.Run(kConfig.ramp_limit_s - 0.05);
  EXPECT_EQ(flight.output.phase, Phase::kRamp);
  EXPECT_TRUE(flight.RunUntil(Phase::kGaveUp, 0.1));
}

TEST(Guidance, HoldsRampSetPointDuringLossAndResumesFromVehicleHeight) {
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

TEST(Guidance, ReturnsFromSearchToRampOfUnfinishedTakeoff) {
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

TEST(Guidance, ReturnsFromSearchToHoverSetPoint) {
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

}  // namespace
}  // namespace touchdown::controller
