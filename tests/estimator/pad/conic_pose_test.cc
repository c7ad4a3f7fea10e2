#include "estimator/pad/conic_pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "models/angles.h"
#include "models/random_stream.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Normalized conic of a circle: Q = H^-T diag(1, 1, -r^2) H^-1, where H = [e1 e2 t] maps the plane to the image.
Matrix3d ConicOfCircle(const Vector3d& n_C, const Vector3d& p_CW, double radius_m) {
  const Vector3d e1 = n_C.unitOrthogonal();
  Matrix3d image_from_plane;
  image_from_plane << e1, n_C.cross(e1), p_CW;
  const Matrix3d plane_from_image = image_from_plane.inverse();
  return plane_from_image.transpose() * Vector3d(1.0, 1.0, -radius_m * radius_m).asDiagonal() * plane_from_image;
}

/// The larger of the errors of both vectors of a pose.
double Error(const CirclePose& pose, const Vector3d& n_C, const Vector3d& p_CW) {
  return std::max((pose.n_C - n_C).norm(), (pose.p_CW - p_CW).norm());
}

TEST(ConicPose, ReturnsBothBranchesOfAnObliqueCircle) {
  models::RandomStream random(1, "tests.conic_pose");
  constexpr double kRadius = 0.09;
  for (int i = 0; i < 500; ++i) {
    const double height = random.Uniform(0.15, 4.0);
    const Vector3d p_CW(height * random.Uniform(-0.9, 0.9), height * random.Uniform(-0.7, 0.7), height);
    const Vector3d n_C =
        models::RotationExp({random.Uniform(-0.9, 0.9), random.Uniform(-0.9, 0.9), 0.0}) * -Vector3d::UnitZ();
    if (n_C.dot(p_CW) > -0.1 * p_CW.norm()) continue;
    const Matrix3d conic = ConicOfCircle(n_C, p_CW, kRadius);
    const auto poses = PosesOfCircle(conic, kRadius);
    ASSERT_TRUE(poses);
    const double first = Error((*poses)[0], n_C, p_CW), second = Error((*poses)[1], n_C, p_CW);
    EXPECT_LT(std::min(first, second), 1e-5);
    for (const CirclePose& pose : *poses) {
      EXPECT_NEAR(pose.n_C.norm(), 1.0, 1e-12);
      EXPECT_LT(pose.n_C.z(), 0.0);   // Eq. 10.
      EXPECT_GT(pose.p_CW.z(), 0.0);  // Eq. 11.
      // Both branches project to the same ellipse.
      const Matrix3d again = ConicOfCircle(pose.n_C, pose.p_CW, kRadius);
      EXPECT_LT((again / again.norm() - conic / conic.norm()).norm(), 1e-7);
    }
  }
}

TEST(ConicPose, SeparatesTheBranchesByTwiceTheTilt) {
  // The two poses of a circle on the optical axis that is tilted by an angle are tilted by this angle to either side.
  const double tilt = models::DegToRad(25.0);
  const auto poses =
      PosesOfCircle(ConicOfCircle({std::sin(tilt), 0.0, -std::cos(tilt)}, {0.0, 0.0, 100.0}, 0.09), 0.09);
  ASSERT_TRUE(poses);
  const double between = std::acos((*poses)[0].n_C.dot((*poses)[1].n_C));
  EXPECT_NEAR(models::RadToDeg(between), 50.0, 0.1);
}

TEST(ConicPose, ReturnsEqualPosesFromStraightAbove) {
  const auto poses = PosesOfCircle(ConicOfCircle(-Vector3d::UnitZ(), {0.0, 0.0, 1.3}, 0.09), 0.09);
  ASSERT_TRUE(poses);
  for (const CirclePose& pose : *poses) {
    EXPECT_LT((pose.n_C + Vector3d::UnitZ()).norm(), 1e-6);
    EXPECT_LT((pose.p_CW - Vector3d(0.0, 0.0, 1.3)).norm(), 1e-6);
  }
}

TEST(ConicPose, DoesNotDependOnScaleAndSignOfTheConic) {
  const Matrix3d conic = ConicOfCircle(Vector3d(0.2, -0.1, -1.0).normalized(), {0.1, 0.2, 0.8}, 0.09);
  const auto expected = PosesOfCircle(conic, 0.09);
  ASSERT_TRUE(expected);
  for (const double scale : {-1.0, 1e6, -1e-6}) {
    const auto poses = PosesOfCircle(scale * conic, 0.09);
    ASSERT_TRUE(poses);
    const bool same_order = ((*poses)[0].n_C - (*expected)[0].n_C).norm() < 1e-6;
    for (std::size_t i = 0; i < 2; ++i) {
      const CirclePose& other = (*expected)[same_order ? i : 1 - i];
      EXPECT_LT(Error((*poses)[i], other.n_C, other.p_CW), 1e-6);
    }
  }
}

TEST(ConicPose, ScalesWithTheRadius) {
  const Matrix3d conic = ConicOfCircle(Vector3d(0.3, 0.1, -1.0).normalized(), {0.1, 0.2, 0.8}, 0.09);
  const auto once = PosesOfCircle(conic, 0.09), twice = PosesOfCircle(conic, 0.18);
  ASSERT_TRUE(once && twice);
  EXPECT_LT(((*twice)[0].p_CW - 2.0 * (*once)[0].p_CW).norm(), 1e-12);
}

TEST(ConicPose, ReturnsNulloptForAConicThatIsNotACone) {
  EXPECT_FALSE(PosesOfCircle(Matrix3d::Identity(), 0.09));
  EXPECT_FALSE(PosesOfCircle(Matrix3d::Zero(), 0.09));
  EXPECT_FALSE(PosesOfCircle(Vector3d(1.0, 0.0, -1.0).asDiagonal(), 0.09));
  EXPECT_FALSE(PosesOfCircle(Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN()), 0.09));
}

}  // namespace
}  // namespace touchdown::estimator::pad
