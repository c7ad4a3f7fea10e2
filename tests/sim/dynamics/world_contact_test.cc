#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "sim/dynamics/world.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using tests::LevelPose;
using tests::QuietWorld;
using tests::StepFor;

double AngleBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return models::RotationLog(a.linear().transpose() * b.linear()).norm();
}

TEST(WorldContact, StaysPutAtTheRestingPose) {
  World world = QuietWorld({});
  const Eigen::Isometry3d rest = world.RestingPose(0.4, -0.3, 0.7);
  world.Reset(rest, false);
  double largest_acceleration = 0.0;
  for (int i = 0; i < 2400; ++i) {
    world.Step({});
    largest_acceleration = std::max(largest_acceleration, world.state().a_WB.norm());
    ASSERT_LT((world.state().X_WB.translation() - rest.translation()).norm(), 1e-5);
    ASSERT_LT(AngleBetween(world.state().X_WB, rest), 1e-5);
    ASSERT_TRUE(world.state().gear_in_contact);
    ASSERT_FALSE(world.state().body_in_contact);
  }
  EXPECT_LT(largest_acceleration, 0.01) << "no jitter";
}

models::Vehicle PalmSized() {
  models::Vehicle vehicle;
  vehicle.mass_kg = 0.030;
  vehicle.inertia_kg_m2 = {1.4e-5, 1.4e-5, 2.2e-5};
  vehicle.arm_m = 0.046;
  vehicle.rotor_height_m = 0.008;
  vehicle.rotor = {.thrust_coefficient_n_s2 = 2.2e-8, .max_speed_rad_s = 2500.0, .propeller_diameter_m = 0.046};
  vehicle.gear = {.half_spacing_m = 0.030, .height_m = 0.020, .foot_radius_m = 0.003};
  vehicle.camera.position_m = {0.0, 0.0, -0.01};
  return vehicle;
}

models::Vehicle Heavy() {
  models::Vehicle vehicle;
  vehicle.mass_kg = 9.0;
  vehicle.inertia_kg_m2 = {0.2, 0.2, 0.35};
  vehicle.arm_m = 0.45;
  vehicle.rotor = {.thrust_coefficient_n_s2 = 1.2e-4, .propeller_diameter_m = 0.45};
  vehicle.gear = {.half_spacing_m = 0.25, .height_m = 0.30, .foot_radius_m = 0.02};
  return vehicle;
}

TEST(WorldContact, VehiclesOfAnySizeRestAndLandOnTheirGear) {
  for (const models::Vehicle& vehicle : {PalmSized(), Heavy()}) {
    World world = QuietWorld(vehicle);
    const double rest = world.RestingPose(0.0, 0.0, 0.0).translation().z();
    EXPECT_NEAR(rest, vehicle.gear.height_m, 0.0005) << vehicle.mass_kg << " kg";
    world.Reset(LevelPose(0.0, 0.0, rest + 0.01), false);
    StepFor(world, {}, 1.0);
    EXPECT_NEAR(world.state().X_WB.translation().z(), rest, 1e-4);
    EXPECT_LT(world.state().v_WB.norm(), 1e-4);
    EXPECT_TRUE(world.state().gear_in_contact);
    EXPECT_FALSE(world.state().body_in_contact);
    world.Reset(LevelPose(0.0, 0.0, 2.0), true);
    StepFor(world, tests::HoverCommand(vehicle), 1.0);
    EXPECT_NEAR(world.state().X_WB.translation().z(), 2.0, 1e-6);
  }
}

TEST(WorldContact, RestsWithItsContactPointsOnTheFloor) {
  const World world = QuietWorld({});
  const Vector3d p = world.RestingPose(1.0, 2.0, 0.5).translation();
  EXPECT_EQ(p.x(), 1.0);
  EXPECT_EQ(p.y(), 2.0);
  EXPECT_NEAR(p.z(), models::Vehicle{}.gear.height_m, 0.0005);
  EXPECT_LT(p.z(), models::Vehicle{}.gear.height_m) << "the gear compresses slightly";
}

TEST(WorldContact, ADropComesToRestWithoutAHighBounce) {
  World world = QuietWorld({});
  const double rest = world.RestingPose(0.0, 0.0, 0.0).translation().z();
  world.Reset(LevelPose(0.0, 0.0, rest + 0.05), false);
  bool touched = false;
  double highest = 0.0, lowest = 1.0;
  for (int i = 0; i < 1800; ++i) {
    world.Step({});
    touched = touched || world.state().gear_in_contact;
    const double above = world.state().X_WB.translation().z() - rest;
    lowest = std::min(lowest, above);
    if (touched && world.state().v_WB.z() > 0.0) highest = std::max(highest, above);
  }
  EXPECT_TRUE(touched);
  EXPECT_GT(lowest, -0.010) << "the gear compresses by less than the foot radius";
  EXPECT_LT(highest, 0.002);
  EXPECT_LT(world.state().v_WB.norm(), 1e-4);
  EXPECT_NEAR(world.state().X_WB.translation().z(), rest, 1e-4);
  EXPECT_FALSE(world.state().body_in_contact);
}

TEST(WorldContact, FirstContactIsAtTheTimeOfFreeFall) {
  World world = QuietWorld(tests::VehicleWithoutDrag());
  for (const double drop_m : {0.10, 0.5, 2.0}) {
    world.Reset(LevelPose(0.0, 0.0, models::Vehicle{}.gear.height_m + drop_m), false);
    while (!world.state().gear_in_contact) world.Step({});
    const double expected_s = std::sqrt(2.0 * drop_m / models::kGravity_m_s2);
    EXPECT_NEAR(models::TimeBase{}.ToSeconds(world.state().tick), expected_s, 1.5 / 1200.0);
  }
}

TEST(WorldContact, SettlesUprightAfterATiltedLanding) {
  World world = QuietWorld({});
  Eigen::Isometry3d start(Eigen::AngleAxisd(models::DegToRad(10.0), Vector3d(1.0, 1.0, 0.0).normalized()));
  start.translation() = Vector3d(0.0, 0.0, 0.21);
  world.Reset(start, false);
  StepFor(world, {}, 2.0);
  EXPECT_LT(AngleBetween(world.state().X_WB, world.RestingPose(0.0, 0.0, 0.0)), models::DegToRad(0.1));
  EXPECT_LT(world.state().w_WB_B.norm(), 1e-3);
  EXPECT_FALSE(world.state().body_in_contact);
}

TEST(WorldContact, FrictionResistsALightPushButNotAStrongOne) {
  World world = QuietWorld({});
  world.SetPush({3.0, 0.0, 0.0}, Vector3d::Zero());
  StepFor(world, {}, 1.0);
  EXPECT_LT(world.state().X_WB.translation().head<2>().norm(), 0.001);
  world.SetPush({0.0, 20.0, 0.0}, Vector3d::Zero());
  StepFor(world, {}, 0.5);
  EXPECT_GT(world.state().X_WB.translation().y(), 0.3);
}

TEST(WorldContact, AFlippedVehicleTouchesWithItsBody) {
  World world = QuietWorld({});
  Eigen::Isometry3d upside_down(Eigen::AngleAxisd(models::kPi, Vector3d::UnitX()));
  upside_down.translation().z() = 0.3;
  world.Reset(upside_down, false);
  EXPECT_FALSE(world.state().body_in_contact);
  StepFor(world, {}, 2.0);
  EXPECT_TRUE(world.state().body_in_contact);
  EXPECT_FALSE(world.state().gear_in_contact);
  EXPECT_LT(world.state().v_WB.norm(), 1e-2);
}

TEST(WorldContact, ACrashAtFullSpeedRaisesNoWarning) {
  World world = QuietWorld({});
  for (const double roll : {0.3, 1.2, 1.6, 2.4, 3.1}) {
    Eigen::Isometry3d start(Eigen::AngleAxisd(roll, Vector3d(1.0, 0.3, 0.0).normalized()));
    start.translation().z() = 3.0;
    world.Reset(start, false);
    models::RotorCommand command = tests::SameSpeed(660.0);
    command.speed_rad_s[1] = 300.0;
    bool crashed = false;
    for (int i = 0; i < 2400; ++i) {
      ASSERT_NO_THROW(world.Step(command));
      crashed = crashed || world.state().body_in_contact;
    }
    EXPECT_TRUE(crashed);
    EXPECT_GT(world.state().X_WB.translation().z(), -0.05) << "stays above the floor";
  }
}

TEST(WorldContact, LandsOnEverySolidObject) {
  const SceneConfig config{.posters = 0, .lone_circles = 0, .lone_letters = 0, .objects = 8};
  const Scene scene = MakeScene(config, models::LandingPad{}, 4);
  ASSERT_EQ(scene.items.size(), 8U);
  World world(tests::StillAndBalanced(), models::Vehicle{}, scene, models::TimeBase{}, 1);
  for (const SceneItem& object : scene.items) {
    world.Reset(LevelPose(object.position_m.x(), object.position_m.y(), 1.5), false);
    while (!world.state().gear_in_contact && !world.state().body_in_contact) world.Step({});
    EXPECT_LT(world.state().X_WB.translation().z(), object.size_m.z() + models::Vehicle{}.gear.height_m + 0.001);
    StepFor(world, {}, 0.5);
    EXPECT_GT(world.state().X_WB.translation().z(), 0.05) << "rests on the object or next to it";
  }
}

TEST(WorldContact, CoveringThePadIsVisibleButHasNoContact) {
  World world = QuietWorld({});
  const int cover = mj_name2id(&world.model(), mjOBJ_GEOM, kPadCoverName);
  ASSERT_GE(cover, 0);
  EXPECT_EQ(world.model().geom_rgba[4 * cover + 3], 0.0F);
  world.CoverPad(true);
  EXPECT_EQ(world.model().geom_rgba[4 * cover + 3], 1.0F);
  const Eigen::Isometry3d before = world.state().X_WB;
  StepFor(world, {}, 0.2);
  EXPECT_TRUE(world.state().X_WB.isApprox(before, 1e-5));
  world.CoverPad(false);
  EXPECT_EQ(world.model().geom_rgba[4 * cover + 3], 0.0F);
}

}  // namespace
}  // namespace touchdown::sim
