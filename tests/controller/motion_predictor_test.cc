#include "controller/motion_predictor.h"

#include <gtest/gtest.h>

#include "tests/support/nominal.h"
#include "tests/support/quadrotor_ode.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using tests::kPeriod_s;
using tests::kVehicle;
using tests::kWeight_n;

TEST(MotionPredictor, KeepsVelocityWhenThrustBalancesWeight) {
  MotionPredictor predictor(kVehicle, kPeriod_s, kWeight_n);
  predictor.Set({.p_WB = {0.0, 0.0, 1.0}, .v_WB = {0.1, -0.2, 0.05}});
  for (int i = 0; i < 200; ++i) predictor.Step({}, kWeight_n, Vector3d::Zero());
  EXPECT_NEAR((predictor.motion().p_WB - Vector3d(0.1, -0.2, 1.05)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((predictor.motion().v_WB - Vector3d(0.1, -0.2, 0.05)).norm(), 0.0, 1e-9);
}

TEST(MotionPredictor, SubtractsTrimAcceleration) {
  MotionPredictor predictor(kVehicle, kPeriod_s, kWeight_n);
  const double tilt = 0.05;
  const Vector3d trim = models::kGravity_m_s2 * std::tan(tilt) * Vector3d::UnitX();
  for (int i = 0; i < 200; ++i) predictor.Step({.pitch = tilt}, kWeight_n / std::cos(tilt), trim);
  EXPECT_NEAR(predictor.motion().v_WB.norm(), 0.0, 1e-3);
}

TEST(MotionPredictor, MatchesRigidBodyDuringOneSecondManeuver) {
  models::Vehicle no_drag = kVehicle;
  no_drag.linear_drag_n_s_m.setZero();
  no_drag.quadratic_drag_n_s2_m2.setZero();
  tests::QuadrotorOde truth(no_drag);
  truth.StartRotorsAtHover();
  truth.state.p.z() = 5.0;
  truth.state.R = models::RotationFromTaitBryan({.roll = 0.1, .pitch = -0.15, .yaw = 0.7});
  MotionPredictor predictor(kVehicle, kPeriod_s, kWeight_n);
  predictor.Set({.p_WB = truth.state.p, .v_WB = truth.state.v});
  models::RotorCommand command;
  command.speed_rad_s.fill(kVehicle.rotor.SpeedFor(1.1 * kWeight_n / 4.0));
  for (int i = 0; i < 200; ++i) {
    predictor.Step(models::TaitBryanFromRotation(truth.state.R), 1.1 * kWeight_n, Vector3d::Zero());
    for (int tick = 0; tick < 6; ++tick) truth.Step(command, kPeriod_s / 6);
  }
  EXPECT_GT(truth.state.v.norm(), 1.0);
  EXPECT_NEAR((predictor.motion().p_WB - truth.state.p).norm(), 0.0, 0.02);
  EXPECT_NEAR((predictor.motion().v_WB - truth.state.v).norm(), 0.0, 0.03);
}

TEST(MotionPredictor, StaysOnGroundUntilThrustExceedsWeight) {
  MotionPredictor predictor(kVehicle, kPeriod_s, 0.0);
  predictor.Set({.p_WB = {0.0, 0.0, 0.14}, .v_WB = Vector3d::Zero()});
  const auto run = [&](double thrust_n) {
    for (int i = 0; i < 200; ++i) {
      predictor.Step({.roll = 0.02}, thrust_n, Vector3d::Zero());
      predictor.StandAt(0.14);
    }
  };
  run(0.9 * kWeight_n);
  EXPECT_DOUBLE_EQ(predictor.motion().p_WB.z(), 0.14);
  EXPECT_NEAR(predictor.motion().p_WB.head<2>().norm(), 0.0, 1e-3);
  run(1.1 * kWeight_n);
  EXPECT_GT(predictor.motion().p_WB.z(), 0.4);
}

}  // namespace
}  // namespace touchdown::controller
