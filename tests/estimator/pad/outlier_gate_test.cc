#include "estimator/pad/outlier_gate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::estimator::pad {
namespace {

constexpr models::Tick kFrame = 20;  // 60 Hz.

Eigen::Isometry3d PoseAt(double x, double y, double z, double roll = 0.0) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << x, y, z;
  X_WB.linear() = models::RotationFromTaitBryan({roll, 0.0, 0.0});
  return X_WB;
}

class OutlierGateTest : public testing::Test {
 protected:
  bool Next(const Eigen::Isometry3d& X_WB) { return gate_.Accepts(tick_ += kFrame, X_WB); }

  OutlierGate gate_{OutlierGateConfig(), models::TimeBase()};
  models::Tick tick_ = 0;
};

TEST_F(OutlierGateTest, AcceptsAFirstPoseNearTheInitialPose) { EXPECT_TRUE(Next(PoseAt(0.05, -0.05, 0.4))); }

TEST(OutlierGate, AcceptsAnyFirstPoseOfASequenceButNoJump) {
  OutlierGate gate({}, {}, FrameOrder::kSequence);
  EXPECT_TRUE(gate.Accepts(0, PoseAt(1.0, 0.5, 2.5, 0.7)));
  EXPECT_FALSE(gate.Accepts(kFrame, PoseAt(-1.0, 0.5, 2.5, 0.7)));
}

TEST(OutlierGate, AcceptsEveryPoseOfUnrelatedImages) {
  OutlierGate gate({}, {}, FrameOrder::kUnrelated);
  EXPECT_TRUE(gate.Accepts(0, PoseAt(1.0, 0.5, 2.5, 0.7)));
  EXPECT_TRUE(gate.Accepts(0, PoseAt(-1.0, 0.5, 1.0)));
}

TEST_F(OutlierGateTest, RejectsAFirstPoseWithTooMuchTilt) {
  EXPECT_FALSE(Next(PoseAt(0.0, 0.0, 0.3, 1.02 * OutlierGateConfig().start_gate_rad)));
  EXPECT_TRUE(Next(PoseAt(0.0, 0.0, 0.3, 0.98 * OutlierGateConfig().start_gate_rad)));
}

TEST_F(OutlierGateTest, AcceptsADistantFirstPoseAfterAgreeingPoses) {
  EXPECT_FALSE(Next(PoseAt(0.3, 0.0, 1.5)));
  EXPECT_FALSE(Next(PoseAt(0.31, 0.0, 1.5)));
  EXPECT_TRUE(Next(PoseAt(0.32, 0.0, 1.5)));
  EXPECT_TRUE(Next(PoseAt(0.33, 0.0, 1.5)));
}

TEST_F(OutlierGateTest, RejectsASingleJumpOfThePosition) {
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.9)));
  EXPECT_FALSE(Next(PoseAt(0.5, 0.0, 0.9)));
  EXPECT_TRUE(Next(PoseAt(0.01, 0.0, 0.9)));
}

TEST_F(OutlierGateTest, RejectsAJumpOfTheTiltAlone) {
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.5)));
  EXPECT_FALSE(Next(PoseAt(0.02, 0.0, 0.5, 0.5)));
  EXPECT_TRUE(Next(PoseAt(0.02, 0.0, 0.5, 0.1)));
}

TEST_F(OutlierGateTest, RecoversFromAJumpOfTheTruePose) {
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.9)));
  int rejected = 0;
  while (!Next(PoseAt(1.0, 1.0, 1.5)) && rejected < 100) ++rejected;
  EXPECT_EQ(rejected, OutlierGateConfig().agreeing_outliers - 1);
  EXPECT_FALSE(Next(PoseAt(0.0, 0.0, 0.9)));
}

TEST_F(OutlierGateTest, RejectsOutliersThatDisagree) {
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.9)));
  for (int i = 0; i < 6; ++i) {
    EXPECT_FALSE(Next(PoseAt(i % 2 == 0 ? 0.8 : -0.8, 0.0, 0.9)));
  }
}

TEST_F(OutlierGateTest, WidensTheGateWithTimeSinceTheLastAcceptedPose) {
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.9)));
  EXPECT_FALSE(Next(PoseAt(0.7, 0.0, 0.9)));
  tick_ += 240;
  EXPECT_TRUE(Next(PoseAt(0.7, 0.0, 0.9)));
}

TEST_F(OutlierGateTest, FollowsFastFlightWithNoise) {
  models::RandomStream random(1, "tests.outlier_gate");
  ASSERT_TRUE(Next(PoseAt(0.0, 0.0, 0.9)));
  for (int i = 1; i < 600; ++i) {
    const double t = i / 60.0;
    // Oscillation of 0.5 m at up to 2.5 m/s and of 20 degrees of roll at up to 1.7 rad/s, with noise of 30 mm and
    // 1.5 degrees.
    EXPECT_TRUE(Next(PoseAt(0.5 * std::sin(5.0 * t) + 0.03 * random.Normal(), 0.03 * random.Normal(), 0.9,
                            0.35 * std::sin(5.0 * t) + 0.026 * random.Normal())));
  }
}

TEST(OutlierGateConfig, RejectsInvalidSettings) {
  EXPECT_THROW(OutlierGateConfig{.max_speed_m_s = 0.0}.Validate(), InputError);
  EXPECT_THROW(OutlierGateConfig{.agreeing_outliers = 0}.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
