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

TEST(Gust, HasA1CosineProfile) {
  const Gust gust{.peak_velocity_m_s = {8.0, 0.0, -2.0}};
  const auto at = [&gust](double elapsed_s) {
    EventEffects effects;
    gust.Apply({.elapsed_s = elapsed_s, .duration_s = 0.4}, effects);
    return effects.gust_m_s;
  };
  EXPECT_TRUE(at(0.0).isZero(1e-12));
  EXPECT_TRUE(at(0.1).isApprox(Eigen::Vector3d(4.0, 0.0, -1.0)));
  EXPECT_TRUE(at(0.2).isApprox(gust.peak_velocity_m_s));
  EXPECT_TRUE(at(0.3).isApprox(at(0.1)));
}

TEST_F(EventPlayerTest, AddsAGustToTheMeanWind) {
  const Event wind{.kind = Wind{.velocity_m_s = {0.0, 4.0, 0.0}}};
  const Event gust{.kind = Gust{.peak_velocity_m_s = {8.0, 0.0, 0.0}}, .at_s = 0.1, .duration_s = 0.4};
  EventPlayer events({wind, gust}, time_);
  FlyTo(events, 120);
  EXPECT_DOUBLE_EQ(world_.state().v_WB.x(), 0.0) << "before the gust";
  FlyTo(events, 600);
  const Eigen::Vector3d after = world_.state().v_WB;
  EXPECT_GT(after.x(), 0.1);
  EXPECT_GT(after.y(), 0.1) << "the mean wind blows too";
  FlyTo(events, 720);
  EXPECT_LT(world_.state().v_WB.x(), after.x()) << "without the gust, drag slows the vehicle down";
  EXPECT_GT(world_.state().v_WB.y(), after.y()) << "the mean wind blows on";
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
