#include "scenarios/runner/end_watch.h"

#include <gtest/gtest.h>

namespace touchdown::runner {
namespace {

using controller::Phase;

class EndWatchTest : public ::testing::Test {
 protected:
  EndWatchTest() {
    control_.phase = Phase::kHover;
    truth_.X_WB.translation() << 0.0, 0.0, 1.0;
  }
  /// Ending within a duration in the same state.
  std::optional<Ending> Within(double seconds) {
    for (const models::Tick end = truth_.tick + scenario_.time.FromSeconds(seconds); truth_.tick < end; ++truth_.tick) {
      if (const auto ending = watch_.Judge(truth_, control_)) return ending;
    }
    return std::nullopt;
  }
  Outcome OutcomeWithin(double seconds) {
    const auto ending = Within(seconds);
    EXPECT_TRUE(ending.has_value());
    return ending ? ending->outcome : Outcome::kError;
  }

  static Scenario WithTimeLimit(double time_limit_s) {
    Scenario scenario;
    scenario.time_limit_s = time_limit_s;
    return scenario;
  }

  const Scenario scenario_ = WithTimeLimit(10.0);
  sim::TrueState truth_;
  controller::ControlOutput control_;
  EndWatch watch_{scenario_};
};

TEST_F(EndWatchTest, ContinuesFlight) { EXPECT_FALSE(Within(5.0)); }

TEST_F(EndWatchTest, EndsFlightAtTimeLimit) {
  EXPECT_FALSE(Within(10.0));
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kGaveUp);
}

TEST_F(EndWatchTest, EndsWithScriptInTheAir) {
  control_.script_done = true;
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kHovered);
}

TEST_F(EndWatchTest, EndsWithHandMotion) {
  Scenario scenario;
  scenario.hand = {.carries = true, .duration_s = 10.0};
  watch_ = EndWatch(scenario);
  control_.phase = Phase::kStandby;
  EXPECT_FALSE(Within(sim::Hand::kTimeAtRest_s + 10.0));
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kHovered);
}

TEST_F(EndWatchTest, ReportsLandedAfterOneSecondAtRest) {
  control_.phase = Phase::kTouchdown;
  control_.script_done = true;
  EXPECT_FALSE(Within(0.2));
  truth_.gear_in_contact = true;
  truth_.v_WB.x() = 0.1;
  EXPECT_FALSE(Within(0.5));
  truth_.v_WB.x() = 0.0;
  EXPECT_FALSE(Within(1.0));
  EXPECT_EQ(OutcomeWithin(0.01), Outcome::kLanded);
}

TEST_F(EndWatchTest, ReportsCrashIfVehicleDoesNotComeToRest) {
  control_.phase = Phase::kTouchdown;
  truth_.v_WB.x() = 0.1;
  EXPECT_EQ(OutcomeWithin(6.0), Outcome::kCrashed);
}

TEST_F(EndWatchTest, ReportsGaveUpWhenGuidanceGivesUp) {
  control_.phase = Phase::kGaveUp;
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kGaveUp);
}

TEST_F(EndWatchTest, DetectsCrashes) {
  const sim::TrueState fine = truth_;
  truth_.body_in_contact = true;
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kCrashed);
  truth_ = fine;
  truth_.X_WB.linear() = models::RotationFromTaitBryan({.roll = models::DegToRad(91), .pitch = 0.0, .yaw = 0.0});
  EXPECT_EQ(OutcomeWithin(0.1), Outcome::kCrashed);
  truth_ = fine;
}

TEST_F(EndWatchTest, DetectsThatVehicleLeftRoom) {
  const double half_m = scenario_.scene.floor_size_m / 2.0;
  for (const Eigen::Vector3d& inside :
       {Eigen::Vector3d(-half_m, half_m, 1.0), Eigen::Vector3d(0.0, 0.0, scenario_.ceiling_m())}) {
    truth_.X_WB.translation() = inside;
    EXPECT_FALSE(Within(0.1));
  }
  for (const Eigen::Vector3d& outside :
       {Eigen::Vector3d(-half_m - 0.01, 0.0, 1.0), Eigen::Vector3d(0.0, half_m + 0.01, 1.0),
        Eigen::Vector3d(0.0, 0.0, scenario_.ceiling_m() + 0.01)}) {
    truth_.X_WB.translation() = outside;
    const auto ending = Within(0.1);
    ASSERT_TRUE(ending.has_value());
    EXPECT_EQ(ending->outcome, Outcome::kCrashed);
    EXPECT_EQ(ending->reason, "the vehicle left the room");
  }
}

}  // namespace
}  // namespace touchdown::runner
