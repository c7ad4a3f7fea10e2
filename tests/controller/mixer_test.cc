#include "controller/mixer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "models/random_stream.h"
#include "tests/support/nominal.h"
#include "tests/support/quadrotor_ode.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using models::Vehicle;
using tests::kVehicle;
using tests::kWeight_n;

Wrench Wanted(double thrust_n, const Vector3d& torque_n_m) { return {.thrust_n = thrust_n, .torque_n_m = torque_n_m}; }

TEST(Mixer, ProducesDemandedWrench) {
  const Mixer mixer(kVehicle);
  models::RandomStream random(1, "mixer_test");
  for (int i = 0; i < 200; ++i) {
    const Wrench wanted = Wanted(random.Uniform(0.7, 1.3) * kWeight_n,
                                 {random.Uniform(-0.2, 0.2), random.Uniform(-0.2, 0.2), random.Uniform(-0.02, 0.02)});
    const Mixer::Result result = mixer.Mix(wanted);
    const Eigen::Vector4d flown = tests::QuadrotorOde::RotorWrench(kVehicle, result.rotors.speed_rad_s);
    EXPECT_NEAR(flown[0], wanted.thrust_n, 1e-9);
    EXPECT_NEAR((flown.tail<3>() - wanted.torque_n_m).norm(), 0.0, 1e-9);
    EXPECT_NEAR(result.achieved.thrust_n, wanted.thrust_n, 1e-9);
    EXPECT_NEAR((result.achieved.torque_n_m - wanted.torque_n_m).norm(), 0.0, 1e-9);
  }
}

TEST(Mixer, SpeedsUpRotorsInDemandedDirection) {
  const Mixer mixer(kVehicle);
  enum { kFrontLeft, kFrontRight, kRearRight, kRearLeft };
  const auto speeds = [&](const Vector3d& torque) { return mixer.Mix(Wanted(kWeight_n, torque)).rotors.speed_rad_s; };

  const auto right_side_down = speeds({0.1, 0.0, 0.0});
  EXPECT_GT(right_side_down[kFrontLeft], right_side_down[kFrontRight]);
  EXPECT_GT(right_side_down[kRearLeft], right_side_down[kRearRight]);
  const auto nose_down = speeds({0.0, 0.1, 0.0});
  EXPECT_GT(nose_down[kRearLeft], nose_down[kFrontLeft]);
  EXPECT_GT(nose_down[kRearRight], nose_down[kFrontRight]);
  const auto turn_left = speeds({0.0, 0.0, 0.02});
  EXPECT_GT(turn_left[kFrontLeft], turn_left[kFrontRight]);  // Clockwise rotors drag the body to the left.
  EXPECT_GT(turn_left[kRearRight], turn_left[kRearLeft]);
}

TEST(Mixer, ReportsAchievedWrenchForAnyDemand) {
  const Mixer mixer(kVehicle);
  models::RandomStream random(2, "mixer_test");
  for (int i = 0; i < 500; ++i) {
    const Wrench wanted = Wanted(random.Uniform(-1.0, 4.0) * kWeight_n,
                                 {random.Uniform(-5.0, 5.0), random.Uniform(-5.0, 5.0), random.Uniform(-1.0, 1.0)});
    const Mixer::Result result = mixer.Mix(wanted);
    const Eigen::Vector4d flown = tests::QuadrotorOde::RotorWrench(kVehicle, result.rotors.speed_rad_s);
    EXPECT_NEAR(flown[0], result.achieved.thrust_n, 1e-9);
    EXPECT_NEAR((flown.tail<3>() - result.achieved.torque_n_m).norm(), 0.0, 1e-9);
    for (const double speed : result.rotors.speed_rad_s) {
      EXPECT_GE(speed, kVehicle.rotor.min_speed_rad_s - 1e-9);
      EXPECT_LE(speed, kVehicle.rotor.max_speed_rad_s + 1e-9);
    }
  }
}

TEST(Mixer, ReducesYawTorqueFirst) {
  const Wrench wanted = Wanted(kWeight_n, {0.5, -0.3, 5.0});
  const Wrench achieved = Mixer(kVehicle).Mix(wanted).achieved;
  EXPECT_NEAR(achieved.thrust_n, wanted.thrust_n, 1e-9);
  EXPECT_NEAR(achieved.torque_n_m.x(), wanted.torque_n_m.x(), 1e-9);
  EXPECT_NEAR(achieved.torque_n_m.y(), wanted.torque_n_m.y(), 1e-9);
  EXPECT_GT(achieved.torque_n_m.z(), 0.0);
  EXPECT_LT(achieved.torque_n_m.z(), 0.2);
}

TEST(Mixer, ReducesThrustBeforeRollAndPitchTorque) {
  const double most_n = 4.0 * kVehicle.rotor.ThrustAt(kVehicle.rotor.max_speed_rad_s);
  for (const double thrust_n : {2.0 * most_n, 0.0}) {
    const Wrench wanted = Wanted(thrust_n, {0.6, 0.2, 0.1});
    const Wrench achieved = Mixer(kVehicle).Mix(wanted).achieved;
    EXPECT_NEAR(achieved.torque_n_m.x(), wanted.torque_n_m.x(), 1e-9);
    EXPECT_NEAR(achieved.torque_n_m.y(), wanted.torque_n_m.y(), 1e-9);
    EXPECT_GE(achieved.torque_n_m.z(), -1e-9);
    EXPECT_LE(achieved.torque_n_m.z(), wanted.torque_n_m.z() + 1e-9);
    EXPECT_LT(achieved.thrust_n, most_n);
    EXPECT_GT(achieved.thrust_n, 0.0);
  }
}

TEST(Mixer, KeepsDirectionOfSaturatedTiltTorque) {
  const Wrench achieved = Mixer(kVehicle).Mix(Wanted(kWeight_n, {30.0, 10.0, 0.0})).achieved;
  EXPECT_NEAR(achieved.torque_n_m.x() / achieved.torque_n_m.y(), 3.0, 1e-6);
  const double span_n =
      kVehicle.rotor.ThrustAt(kVehicle.rotor.max_speed_rad_s) - kVehicle.rotor.ThrustAt(kVehicle.rotor.min_speed_rad_s);
  // Two rotors at the extremes, the other two between: |tx| + |ty| = 2 span times the arm's component.
  const double lever_m = kVehicle.arm_m / std::numbers::sqrt2;
  EXPECT_NEAR(achieved.torque_n_m.x() + achieved.torque_n_m.y(), 2.0 * span_n * lever_m, 1e-6);
}

TEST(Mixer, NeverStopsRotorInFlight) {
  const Mixer::Result result = Mixer(kVehicle).Mix(Wanted(-10.0, Vector3d::Zero()));
  for (const double speed : result.rotors.speed_rad_s) EXPECT_NEAR(speed, kVehicle.rotor.min_speed_rad_s, 1e-9);
}

}  // namespace
}  // namespace touchdown::controller
