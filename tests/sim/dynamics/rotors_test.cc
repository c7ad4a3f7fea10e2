#include "sim/dynamics/rotors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/error.h"
#include "tests/support/nominal.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using tests::kTime;
using tests::SameSpeed;

constexpr VibrationConfig kBalanced{.imbalance_kg_m = 0.0};

TEST(Rotors, FollowAStepAsAFirstOrderLag) {
  const models::Vehicle vehicle;
  Rotors rotors(vehicle, kBalanced, kTime, 1);
  rotors.Reset(100.0);
  for (int tick = 1; tick <= 240; ++tick) {
    rotors.Step(SameSpeed(500.0));
    const double t = tick * kTime.period_s();
    const double expected = 100.0 + 400.0 * (1.0 - std::exp(-t / vehicle.rotor.time_constant_s));
    for (const double speed : rotors.speeds_rad_s()) ASSERT_NEAR(speed, expected, 1e-9) << "at " << t << " s";
  }
}

TEST(Rotors, StayWithinTheirSpeedLimits) {
  const models::Vehicle vehicle;
  Rotors rotors(vehicle, kBalanced, kTime, 1);
  for (int tick = 0; tick < 1200; ++tick) rotors.Step(SameSpeed(1e6));
  for (const double speed : rotors.speeds_rad_s()) EXPECT_NEAR(speed, vehicle.rotor.max_speed_rad_s, 1e-6);
  for (int tick = 0; tick < 1200; ++tick) rotors.Step(SameSpeed(-1e6));
  for (const double speed : rotors.speeds_rad_s()) {
    EXPECT_GE(speed, 0.0);
    EXPECT_NEAR(speed, 0.0, 1e-6);
  }
}

TEST(Rotors, HaveTheThrustOfTheirSpeedAndNoTorqueWhenEqual) {
  const models::Vehicle vehicle;
  Rotors rotors(vehicle, kBalanced, kTime, 1);
  rotors.Reset(480.0);
  const Wrench wrench = rotors.Step(SameSpeed(480.0));
  EXPECT_TRUE(wrench.force_n.isApprox(Eigen::Vector3d(0.0, 0.0, 4.0 * 1.29e-5 * 480.0 * 480.0), 1e-12));
  EXPECT_LT(wrench.torque_n_m.norm(), 1e-12);
}

/// Expected signs: more thrust on the left rolls right, more thrust in front pitches the nose up (negative pitch).
TEST(Rotors, ApplyTorqueAccordingToTheirPosition) {
  const models::Vehicle vehicle;
  Rotors rotors(vehicle, kBalanced, kTime, 1);
  const double lever = 0.20 / std::sqrt(2.0);
  const auto torque_of = [&](int rotor) {
    rotors.Reset(0.0);
    models::RotorCommand command;
    command.speed_rad_s[rotor] = 400.0;
    Wrench wrench;
    for (int tick = 0; tick < 2400; ++tick) wrench = rotors.Step(command);
    return Eigen::Vector3d(wrench.torque_n_m / (1.29e-5 * 400.0 * 400.0));
  };
  EXPECT_TRUE(torque_of(0).isApprox(Eigen::Vector3d(lever, -lever, 0.0165), 1e-9)) << "front left";
  EXPECT_TRUE(torque_of(1).isApprox(Eigen::Vector3d(-lever, -lever, -0.0165), 1e-9)) << "front right";
  EXPECT_TRUE(torque_of(2).isApprox(Eigen::Vector3d(-lever, lever, 0.0165), 1e-9)) << "rear right";
  EXPECT_TRUE(torque_of(3).isApprox(Eigen::Vector3d(lever, lever, -0.0165), 1e-9)) << "rear left";
}

TEST(Rotors, RotateTheirImbalanceAgainstTheirDragTorque) {
  Rotors rotors(models::Vehicle{}, VibrationConfig{}, kTime, 1);
  rotors.Reset(300.0);
  const auto before = rotors.angles_rad();
  rotors.Step(SameSpeed(300.0));
  const double rotation = 300.0 * kTime.period_s();
  for (int i = 0; i < models::kRotorCount; ++i) {
    const double expected = models::WrapToPi(before[i] - models::Vehicle::DragTorqueSign(i) * rotation);
    EXPECT_NEAR(rotors.angles_rad()[i], expected, 1e-9);
  }
}

TEST(Rotors, HaveImbalanceForcesInPlaneProportionalToSquaredSpeed) {
  Rotors rotors(models::Vehicle{}, VibrationConfig{.imbalance_kg_m = 2e-6}, kTime, 1);
  rotors.Reset(200.0);
  const Wrench slow = rotors.Imbalance();
  rotors.Reset(400.0);
  const Wrench fast = rotors.Imbalance();
  EXPECT_EQ(slow.force_n.z(), 0.0);
  EXPECT_GT(slow.force_n.norm(), 0.0);
  EXPECT_LE(slow.force_n.norm(), 4.0 * 1.2 * 2e-6 * 200.0 * 200.0);
  EXPECT_TRUE(fast.force_n.isApprox(4.0 * slow.force_n, 1e-12));
  EXPECT_TRUE(fast.torque_n_m.isApprox(4.0 * slow.torque_n_m, 1e-12));
}

TEST(Rotors, DrawTheirPhasesFromTheSeed) {
  const models::Vehicle vehicle;
  EXPECT_EQ(Rotors(vehicle, {}, kTime, 7).angles_rad(), Rotors(vehicle, {}, kTime, 7).angles_rad());
  EXPECT_NE(Rotors(vehicle, {}, kTime, 7).angles_rad(), Rotors(vehicle, {}, kTime, 8).angles_rad());
}

TEST(VibrationConfig, RejectsAnInvalidImbalance) {
  EXPECT_THROW(VibrationConfig{.imbalance_kg_m = -1e-9}.Validate(), InputError);
  EXPECT_THROW(VibrationConfig{.imbalance_kg_m = std::nan("")}.Validate(), InputError);
  EXPECT_NO_THROW(VibrationConfig{.imbalance_kg_m = 0.0}.Validate());
}

}  // namespace
}  // namespace touchdown::sim
