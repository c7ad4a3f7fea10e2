#include "scenarios/runner/event_player.h"

#include <gtest/gtest.h>

#include "sim/dynamics/world.h"
#include "tests/support/worlds.h"

namespace touchdown::runner {
namespace {

/// A vehicle in free fall with its rotors stopped, far above an empty floor.
class EventPlayerTest : public ::testing::Test {
 protected:
  static sim::World MakeWorld() {
    return {tests::Unpainted(), models::Vehicle(), tests::EmptyRoom(), models::TimeBase(), 1};
  }

  void SetUp() override {
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    X_WB.translation().z() = 100.0;
    world_.Reset(X_WB, false);
  }

  /// Lets time pass up to a tick.
  void FlyTo(EventPlayer& events, models::Tick tick) {
    while (world_.state().tick < tick) {
      events.Apply(world_.state().tick, world_);
      world_.Step({});
    }
    events.Apply(tick, world_);
  }

  sim::World world_ = MakeWorld();
  models::TimeBase time_;
};

TEST_F(EventPlayerTest, PushesFromItsTimeForItsDuration) {
  const Event push{.kind = Push{.force_n = {1.2, 0.0, 0.0}}, .at_s = 0.1, .duration_s = 0.2};
  EventPlayer events({push}, time_);
  FlyTo(events, 120);
  EXPECT_DOUBLE_EQ(world_.state().v_WB.x(), 0.0);
  FlyTo(events, 121);
  EXPECT_GT(world_.state().v_WB.x(), 0.0);
  FlyTo(events, 360);
  // 1 m/s^2 for 0.2 s, less a little drag.
  EXPECT_NEAR(world_.state().v_WB.x(), 0.2, 0.01);
  const double speed = world_.state().v_WB.x();
  FlyTo(events, 480);
  EXPECT_LE(world_.state().v_WB.x(), speed);
}

TEST_F(EventPlayerTest, AddsPushesThatOverlap) {
  const Event push{.kind = Push{.force_n = {0.6, 0.0, 0.0}}, .duration_s = 0.2};
  EventPlayer events({push, push}, time_);
  FlyTo(events, 240);
  EXPECT_NEAR(world_.state().v_WB.x(), 0.2, 0.01);
}

TEST_F(EventPlayerTest, KeepsTheNewestWind) {
  const Event wind{.kind = Wind{.velocity_m_s = {0.0, 5.0, 0.0}}, .at_s = 0.1};
  EventPlayer events({wind}, time_);
  FlyTo(events, 120);
  EXPECT_DOUBLE_EQ(world_.state().v_WB.y(), 0.0);
  FlyTo(events, 1200);
  EXPECT_GT(world_.state().v_WB.y(), 0.5);
}

TEST_F(EventPlayerTest, BlowsAGustOnTopOfTheMeanWind) {
  // Still air before and after; a gust of 8 m/s along X with a mean wind of 4 m/s along Y.
  const Event wind{.kind = Wind{.velocity_m_s = {0.0, 4.0, 0.0}}};
  const Event gust{.kind = Gust{.peak_velocity_m_s = {8.0, 0.0, 0.0}}, .at_s = 0.1, .duration_s = 0.4};
  EventPlayer events({wind, gust}, time_);
  const auto acceleration_x = [&](models::Tick tick) {
    FlyTo(events, tick);
    world_.Step({});
    return world_.state().a_WB.x();
  };
  EXPECT_DOUBLE_EQ(acceleration_x(119), 0.0);
  const double quarter = acceleration_x(240), peak = acceleration_x(360), three_quarters = acceleration_x(480);
  EXPECT_GT(peak, 1.5 * quarter);
  EXPECT_NEAR(three_quarters, quarter, 0.2 * quarter) << "the profile is symmetric; the vehicle gains some speed";
  EXPECT_LE(acceleration_x(600), 0.0) << "after the gust, drag slows the vehicle down";
  EXPECT_GT(world_.state().v_WB.y(), 0.0) << "the mean wind is unchanged";
}

TEST_F(EventPlayerTest, CoversThePadAndLosesFramesForAWhile) {
  const Event cover{.kind = CoverPad{}, .at_s = 0.1, .duration_s = 0.1};
  const Event lose{.kind = LoseFrames{}, .at_s = 0.15, .duration_s = 0.1};
  EventPlayer events({cover, lose}, time_);
  const auto at = [&](models::Tick tick) {
    events.Apply(tick, world_);
    return std::pair(events.pad_is_covered(), events.frames_are_lost());
  };
  EXPECT_EQ(at(119), std::pair(false, false));
  EXPECT_EQ(at(120), std::pair(true, false));
  EXPECT_EQ(at(180), std::pair(true, true));
  EXPECT_EQ(at(240), std::pair(false, true));
  EXPECT_EQ(at(300), std::pair(false, false));
}

}  // namespace
}  // namespace touchdown::runner
