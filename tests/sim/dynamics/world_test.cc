#include "sim/dynamics/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/nominal.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using tests::EmptyRoom;
using tests::HoverCommand;
using tests::kG;
using tests::kTime;
using tests::LevelPose;
using tests::QuietWorld;
using tests::SameSpeed;
using tests::StepFor;
using tests::StillAndBalanced;
using tests::VehicleWithoutDrag;

TEST(World, StartsAtTickZeroAtRestOnItsGear) {
  const World world = QuietWorld({});
  EXPECT_EQ(world.state().tick, 0);
  EXPECT_TRUE(world.state().X_WB.isApprox(world.RestingPose(0.0, 0.0, 0.0)));
  EXPECT_EQ(world.state().v_WB, Vector3d::Zero());
  EXPECT_EQ(world.state().a_WB, Vector3d::Zero());
  EXPECT_TRUE(world.state().gear_in_contact);
  EXPECT_FALSE(world.state().body_in_contact);
}

TEST(World, FallsFreelyWithoutDrag) {
  World world = QuietWorld(VehicleWithoutDrag());
  world.Reset(LevelPose(0.3, -0.2, 10.0), false);
  for (int tick = 1; tick <= 1200; ++tick) {
    world.Step({});
    const double t = kTime.ToSeconds(tick);
    ASSERT_EQ(world.state().tick, tick);
    ASSERT_NEAR(world.state().X_WB.translation().z(), 10.0 - 0.5 * kG * t * t, 1e-9);
    ASSERT_NEAR(world.state().v_WB.z(), -kG * t, 1e-9);
    ASSERT_NEAR(world.state().a_WB.z(), -kG, 1e-9);
  }
  EXPECT_NEAR(world.state().X_WB.translation().x(), 0.3, 1e-12);
  EXPECT_FALSE(world.state().gear_in_contact);
}

TEST(World, CarrySetsPoseAndVelocities) {
  World world = QuietWorld({});
  const Vector3d a_W(0.5, -0.2, 1.0), w_B(0.2, -0.3, 0.4);
  const Vector3d p_W = world.state().X_WB.translation();
  for (int tick = 1; tick <= 600; ++tick) {
    const double t = kTime.ToSeconds(tick);
    BodyMotion motion{.v_WB = a_W * t, .w_WB_B = w_B};
    motion.X_WB.linear() = models::RotationExp(w_B * t);
    motion.X_WB.translation() = p_W + 0.5 * a_W * t * t;
    world.Carry(motion);
    ASSERT_EQ(world.state().tick, tick);
    ASSERT_TRUE(world.state().X_WB.isApprox(motion.X_WB, 1e-12));
    ASSERT_TRUE(world.state().a_WB.isApprox(a_W, 1e-9));
  }
  EXPECT_FALSE(world.state().gear_in_contact);
  EXPECT_TRUE(world.state().alpha_WB_B.isZero(1e-9));
  EXPECT_THROW(world.Carry({.X_WB = Eigen::Isometry3d(Eigen::Matrix4d::Constant(std::nan("")))}), SimulationError);
}

TEST(World, ReachesTheTerminalVelocityOfItsDrag) {
  const models::Vehicle vehicle;
  World world = QuietWorld(vehicle);
  world.Reset(LevelPose(0.0, 0.0, 500.0), false);
  StepFor(world, {}, 15.0);
  const double c = vehicle.linear_drag_n_s_m.z(), q = vehicle.quadratic_drag_n_s2_m2.z();
  const double terminal = (-c + std::sqrt(c * c + 4.0 * q * vehicle.mass_kg * kG)) / (2.0 * q);
  EXPECT_NEAR(-world.state().v_WB.z(), terminal, 1e-4 * terminal);
}

TEST(World, HoversWhenTheRotorsCarryTheWeight) {
  const models::Vehicle vehicle;
  World world = QuietWorld(vehicle);
  const Eigen::Isometry3d start = LevelPose(0.0, 0.0, 1.0);
  world.Reset(start, true);
  StepFor(world, HoverCommand(vehicle), 5.0);
  EXPECT_TRUE(world.state().X_WB.isApprox(start, 1e-6));
}

TEST(World, ClimbsByTheExcessOfThrust) {
  const models::Vehicle vehicle = VehicleWithoutDrag();
  World world = QuietWorld(vehicle);
  world.Reset(LevelPose(0.0, 0.0, 1.0), true);
  StepFor(world, SameSpeed(550.0), 1.0);
  const double expected = 4.0 * vehicle.rotor.thrust_coefficient_n_s2 * 550.0 * 550.0 / vehicle.mass_kg - kG;
  EXPECT_NEAR(world.state().a_WB.z(), expected, 1e-6);
}

/// Two rotors are faster and two slower, with the same collective thrust: the angular acceleration is torque divided by
/// inertia.
class DifferentialThrust : public ::testing::Test {
 protected:
  Vector3d AngularAcceleration(const std::array<int, 4>& signs) {
    world_.Reset(LevelPose(0.0, 0.0, 5.0), true);
    models::RotorCommand command;
    for (int i = 0; i < models::kRotorCount; ++i) {
      command.speed_rad_s[i] = vehicle_.rotor.SpeedFor(vehicle_.HoverThrustPerRotor() + signs[i] * kDelta_n);
    }
    StepFor(world_, command, 0.6);
    return world_.state().alpha_WB_B;
  }

  static constexpr double kDelta_n = 1e-3;
  models::Vehicle vehicle_ = VehicleWithoutDrag();
  World world_{StillAndBalanced(), vehicle_, EmptyRoom(), kTime, 1};
  double lever_m_ = vehicle_.arm_m / std::sqrt(2.0);
};

TEST_F(DifferentialThrust, MoreThrustOnTheLeftRollsRight) {
  const Vector3d alpha = AngularAcceleration({+1, -1, -1, +1});
  EXPECT_NEAR(alpha.x(), 4.0 * kDelta_n * lever_m_ / vehicle_.inertia_kg_m2.x(), 1e-5);
  EXPECT_NEAR(alpha.y(), 0.0, 1e-5);
  EXPECT_GT(models::TaitBryanFromRotation(world_.state().X_WB.linear()).roll, 0.0);
  EXPECT_LT(world_.state().v_WB.y(), 0.0) << "and drifts to the right";
}

TEST_F(DifferentialThrust, MoreThrustAtTheRearPitchesDown) {
  const Vector3d alpha = AngularAcceleration({-1, -1, +1, +1});
  EXPECT_NEAR(alpha.y(), 4.0 * kDelta_n * lever_m_ / vehicle_.inertia_kg_m2.y(), 1e-5);
  EXPECT_GT(world_.state().v_WB.x(), 0.0) << "and flies forward";
}

TEST_F(DifferentialThrust, MoreThrustOfTheClockwisePairYawsLeft) {
  const Vector3d alpha = AngularAcceleration({+1, -1, +1, -1});
  EXPECT_NEAR(alpha.z(), 4.0 * kDelta_n * vehicle_.rotor.torque_ratio_m / vehicle_.inertia_kg_m2.z(), 1e-6);
  EXPECT_GT(models::TaitBryanFromRotation(world_.state().X_WB.linear()).yaw, 0.0);
}

TEST(World, ConservesEnergyAndAngularMomentumOfATumblingBody) {
  const models::Vehicle vehicle = VehicleWithoutDrag();
  World world = QuietWorld(vehicle);
  world.Reset(LevelPose(0.0, 0.0, 50.0), false);
  world.SetPush({1.0, 2.0, 0.0}, {0.6, 0.1, 0.3});
  StepFor(world, {}, 0.2);
  world.SetPush(Vector3d::Zero(), Vector3d::Zero());

  const auto momentum = [&] {
    const TrueState& s = world.state();
    return Vector3d(s.X_WB.linear() * vehicle.inertia_kg_m2.cwiseProduct(s.w_WB_B));
  };
  const auto energy = [&] {
    const TrueState& s = world.state();
    return 0.5 * vehicle.mass_kg * s.v_WB.squaredNorm() +
           0.5 * s.w_WB_B.dot(vehicle.inertia_kg_m2.cwiseProduct(s.w_WB_B)) +
           vehicle.mass_kg * kG * s.X_WB.translation().z();
  };
  const Vector3d momentum_before = momentum();
  const double energy_before = energy();
  ASSERT_GT(world.state().w_WB_B.norm(), 5.0);
  StepFor(world, {}, 2.0);
  EXPECT_TRUE(momentum().isApprox(momentum_before, 1e-5));
  EXPECT_NEAR(energy(), energy_before, 1e-9 * energy_before);
}

TEST(World, AppliesPushesInWorldAxes) {
  const models::Vehicle vehicle = VehicleWithoutDrag();
  World world = QuietWorld(vehicle);
  Eigen::Isometry3d start(Eigen::AngleAxisd(2.0, Vector3d::UnitZ()));
  start.translation().z() = 5.0;
  world.Reset(start, false);
  world.SetPush({3.0, 0.0, vehicle.mass_kg * kG}, {0.0, 0.01, 0.0});
  world.Step({});
  EXPECT_TRUE(world.state().a_WB.isApprox(Vector3d(3.0 / vehicle.mass_kg, 0.0, 0.0), 1e-6));
  const Vector3d alpha_W = world.state().X_WB.linear() * world.state().alpha_WB_B;
  EXPECT_TRUE(alpha_W.isApprox(Vector3d(0.0, 0.01 / vehicle.inertia_kg_m2.y(), 0.0), 1e-3)) << alpha_W.transpose();
}

/// Compares the drift with an independent integration of m dv/dt = (c + q |w - v|) (w - v) for a level vehicle with
/// velocity v in wind w.
TEST(World, DriftsWithTheWind) {
  const models::Vehicle vehicle;
  World world = QuietWorld(vehicle);
  world.Reset(LevelPose(0.0, 0.0, 2.0), true);
  world.SetWind({3.0, 0.0, 0.0});
  StepFor(world, HoverCommand(vehicle), 3.0);

  double v = 0.0, x = 0.0;
  constexpr double kStep_s = 1e-5;
  for (int i = 0; i < 300000; ++i) {
    const double c = vehicle.linear_drag_n_s_m.x() + vehicle.quadratic_drag_n_s2_m2.x() * std::abs(3.0 - v);
    v += kStep_s * c * (3.0 - v) / vehicle.mass_kg;
    x += kStep_s * v;
  }
  EXPECT_NEAR(world.state().v_WB.x(), v, 1e-3);
  EXPECT_NEAR(world.state().X_WB.translation().x(), x, 2e-3);
}

TEST(World, UsesTheMeanWindOfItsConfig) {
  const models::Vehicle vehicle;
  WorldConfig config = StillAndBalanced();
  config.wind_m_s = {0.0, -2.0, 0.0};
  World world(config, vehicle, EmptyRoom(), kTime, 1);
  world.Reset(LevelPose(0.0, 0.0, 2.0), true);
  StepFor(world, HoverCommand(vehicle), 1.0);
  EXPECT_LT(world.state().v_WB.y(), -0.1);
}

TEST(World, AcceleratesWithTheImbalanceForces) {
  const models::Vehicle vehicle = VehicleWithoutDrag();
  World world(tests::Unpainted(), vehicle, EmptyRoom(), kTime, 3);
  world.Reset(LevelPose(0.0, 0.0, 2.0), true);
  const double amplitude = world.state().vibration_m_s2_B.norm();
  for (int i = 0; i < 120; ++i) {
    const Vector3d before = world.state().vibration_m_s2_B;
    world.Step(HoverCommand(vehicle));
    const Vector3d mean = 0.5 * (before + world.state().vibration_m_s2_B);
    EXPECT_LT((world.state().a_WB - mean).norm(), 0.05 * std::max(amplitude, 0.2)) << "at tick " << i;
  }
}

void FlyRandomly(World& world, int ticks, std::vector<TrueState>& states) {
  models::RandomStream random(5, "test");
  world.Reset(world.RestingPose(0.0, 0.0, 0.3), false);
  for (int i = 0; i < ticks; ++i) {
    models::RotorCommand command;
    for (double& speed : command.speed_rad_s) speed = random.Uniform(350.0, 640.0);
    world.Step(command);
    states.push_back(world.state());
  }
}

bool SameBits(const TrueState& a, const TrueState& b) {
  return a.tick == b.tick && a.X_WB.matrix() == b.X_WB.matrix() && a.v_WB == b.v_WB && a.w_WB_B == b.w_WB_B &&
         a.a_WB == b.a_WB && a.alpha_WB_B == b.alpha_WB_B && a.rotor_speed_rad_s == b.rotor_speed_rad_s &&
         a.gear_in_contact == b.gear_in_contact && a.body_in_contact == b.body_in_contact;
}

TEST(World, RepeatsAFlightBitForBit) {
  World first(tests::Unpainted(), models::Vehicle{}, EmptyRoom(), kTime, 11);
  World second(tests::Unpainted(), models::Vehicle{}, EmptyRoom(), kTime, 11);
  World other_seed(tests::Unpainted(), models::Vehicle{}, EmptyRoom(), kTime, 12);
  std::vector<TrueState> a, b, again, c;
  constexpr int kTicks = 2400;
  FlyRandomly(first, kTicks, a);
  FlyRandomly(second, kTicks, b);
  FlyRandomly(first, kTicks, again);
  FlyRandomly(other_seed, kTicks, c);
  for (int i = 0; i < kTicks; ++i) {
    ASSERT_TRUE(SameBits(a[i], b[i])) << "two worlds, at tick " << i;
    ASSERT_TRUE(SameBits(a[i], again[i])) << "after a reset, at tick " << i;
  }
  EXPECT_FALSE(SameBits(a.back(), c.back()));
}

TEST(World, ResetClearsPushAndWind) {
  const models::Vehicle vehicle;
  World world = QuietWorld(vehicle);
  world.SetPush({5.0, 0.0, 0.0}, {0.0, 0.1, 0.0});
  world.SetWind({5.0, 0.0, 0.0});
  world.Reset(LevelPose(0.0, 0.0, 1.0), true);
  StepFor(world, HoverCommand(vehicle), 0.5);
  EXPECT_TRUE(world.state().X_WB.isApprox(LevelPose(0.0, 0.0, 1.0), 1e-6));
}

TEST(World, RunsAtAnyTimeBase) {
  const models::Vehicle vehicle = VehicleWithoutDrag();
  World world(StillAndBalanced(), vehicle, EmptyRoom(), models::TimeBase{.ticks_per_s = 600}, 1);
  world.Reset(LevelPose(0.0, 0.0, 10.0), false);
  for (int i = 0; i < 600; ++i) world.Step({});
  EXPECT_NEAR(world.state().X_WB.translation().z(), 10.0 - 0.5 * kG, 1e-9);
}

TEST(World, RejectsInvalidConfigs) {
  models::Vehicle vehicle;
  vehicle.mass_kg = -1.0;
  EXPECT_THROW(QuietWorld(vehicle), InputError);
  WorldConfig config;
  config.wind_m_s.x() = std::nan("");
  EXPECT_THROW(World(config, models::Vehicle{}, EmptyRoom(), kTime, 1), InputError);
}

}  // namespace
}  // namespace touchdown::sim
