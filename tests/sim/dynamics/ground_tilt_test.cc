#include "sim/dynamics/ground_tilt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"
#include "sim/sensors/imu.h"
#include "tests/support/nominal.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using tests::kG;

constexpr GroundTilt kSlope{.roll_deg = 2.9, .pitch_deg = -4.6};

/// Expected gravity in W, written out where the code multiplies matrices.
Vector3d GravityOnTheSlope() {
  const double roll = models::DegToRad(kSlope.roll_deg), pitch = models::DegToRad(kSlope.pitch_deg);
  return kG * Vector3d(std::sin(pitch), -std::cos(pitch) * std::sin(roll), -std::cos(pitch) * std::cos(roll));
}

World WorldOnTheSlope() {
  WorldConfig config = tests::StillAndBalanced();
  config.ground_tilt = kSlope;
  return World(config, tests::VehicleWithoutDrag(), tests::EmptyRoom(), models::TimeBase{}, 1);
}

TEST(GroundTilt, GravityPointsStraightDownOnLevelGround) { EXPECT_EQ(GroundTilt{}.Gravity(), Vector3d(0.0, 0.0, -kG)); }

TEST(GroundTilt, PositiveRollLowersTheRightAndPositivePitchTheFront) {
  EXPECT_LT(GroundTilt{.roll_deg = 5.0}.Gravity().y(), 0.0);
  EXPECT_GT(GroundTilt{.pitch_deg = 5.0}.Gravity().x(), 0.0);
  EXPECT_TRUE(kSlope.Gravity().isApprox(GravityOnTheSlope(), 1e-12));
}

TEST(GroundTilt, RejectsSlopesAbove15Degrees) {
  EXPECT_NO_THROW((GroundTilt{.roll_deg = 10.5, .pitch_deg = 10.5}.Validate()));
  EXPECT_THROW((GroundTilt{.roll_deg = 10.9, .pitch_deg = 10.9}.Validate()), InputError);
  EXPECT_THROW(GroundTilt{.roll_deg = 178.0}.Validate(), InputError);
  EXPECT_THROW(GroundTilt{.pitch_deg = std::nan("")}.Validate(), InputError);
}

TEST(GroundTilt, VehiclesFallAlongTiltedGravity) {
  World world = WorldOnTheSlope();
  world.Reset(tests::LevelPose(0.3, -0.2, 10.0), false);
  tests::StepFor(world, {}, 1.0);
  EXPECT_LT((world.state().v_WB - GravityOnTheSlope()).norm(), 1e-8);
  EXPECT_LT((world.state().X_WB.translation() - Vector3d(0.3, -0.2, 10.0) - 0.5 * GravityOnTheSlope()).norm(), 1e-8);
}

TEST(GroundTilt, ImuMeasuresTiltedGravityAtRestAndZeroInFreeFall) {
  const ImuConfig perfect{.gyro_noise_rad_s_sqrt_hz = 0.0,
                          .accelerometer_noise_m_s2_sqrt_hz = 0.0,
                          .gyro_bias_sigma_deg_s = 0.0,
                          .accelerometer_bias_sigma_m_s2 = 0.0};
  Imu imu(perfect, Eigen::Isometry3d::Identity(), models::TimeBase{}, 1, kSlope);
  TrueState truth;
  truth.X_WB.linear() = models::RotationFromTaitBryan({.roll = 0.0, .pitch = 0.0, .yaw = 0.7});
  const Vector3d up_B = truth.X_WB.linear().transpose() * -GravityOnTheSlope();
  EXPECT_TRUE(imu.Sample(truth)->specific_force_U.isApprox(up_B, 1e-12));
  truth.tick = 6;
  truth.a_WB = GravityOnTheSlope();
  EXPECT_LT(imu.Sample(truth)->specific_force_U.norm(), 1e-12);
}

/// MuJoCo's soft friction creeps by about 0.03 mm/s on this slope.
TEST(GroundTilt, FrictionHoldsAVehicleAtRest) {
  World world = WorldOnTheSlope();
  const Eigen::Isometry3d rest = world.RestingPose(0.1, 0.2, 0.5);
  world.Reset(rest, false);
  double largest_acceleration = 0.0;
  for (int i = 0; i < 3600; ++i) {
    world.Step({});
    largest_acceleration = std::max(largest_acceleration, world.state().a_WB.norm());
    ASSERT_TRUE(world.state().gear_in_contact);
  }
  EXPECT_LT((world.state().X_WB.translation() - rest.translation()).norm(), 0.0002);
  EXPECT_LT(models::RotationLog(rest.linear().transpose() * world.state().X_WB.linear()).norm(), 1e-3);
  EXPECT_LT(largest_acceleration, 0.2) << "the resting pose is nearly in equilibrium";
}

}  // namespace
}  // namespace touchdown::sim
