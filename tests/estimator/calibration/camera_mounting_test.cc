#include "estimator/calibration/camera_mounting.h"

#include <gtest/gtest.h>

#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"
#include "models/vehicle.h"
#include "tests/support/random_pose.h"

namespace touchdown::estimator::calibration {
namespace {

using Eigen::Isometry3d;

Isometry3d RandomMounting(models::RandomStream& random) {
  models::Vehicle vehicle;
  vehicle.camera.position_m = 0.05 * random.NormalVector3();
  vehicle.camera.misalignment_deg = {random.Uniform(-12.0, 12.0), random.Uniform(-12.0, 12.0),
                                     random.Uniform(-170.0, 170.0)};
  return vehicle.X_BC();
}

void Perturb(Isometry3d& X, double position_m, double rotation_rad, models::RandomStream& random) {
  X.translation() += position_m * random.NormalVector3();
  X.linear() = X.linear() * models::RotationExp(rotation_rad * random.NormalVector3());
}

/// Views of a pattern from half a meter. `error` scales the measurement errors; 0 means exact measurements.
std::vector<PatternView> Views(const Isometry3d& X_BC, int count, double error, models::RandomStream& random) {
  std::vector<PatternView> views;
  for (int i = 0; i < count; ++i) {
    PatternView view{.X_WE = tests::RandomPose(random), .X_EC = tests::RandomPose(random)};
    view.X_EC.translation() = 0.5 * view.X_EC.translation().normalized();
    view.X_WB = view.X_WE * view.X_EC * X_BC.inverse();
    Perturb(view.X_WB, 0.002 * error, 0.0087 * error, random);
    Perturb(view.X_WE, 0.002 * error, 0.0087 * error, random);
    views.push_back(view);
  }
  return views;
}

TEST(CameraMounting, IsExactForViewsWithoutErrors) {
  models::RandomStream random(1, "test");
  for (int i = 0; i < 100; ++i) {
    const Isometry3d X_BC = RandomMounting(random);
    const std::vector<PatternView> views = Views(X_BC, 1 + i % 3, 0.0, random);
    EXPECT_TRUE(CameraInBody(views.front()).isApprox(X_BC, 1e-12));
    EXPECT_TRUE(FindCameraMounting(views).X_AB.isApprox(X_BC, 1e-9));
  }
}

TEST(CameraMounting, HasAnErrorThatDecreasesWithTheNumberOfViews) {
  models::RandomStream random(2, "test");
  constexpr int kRuns = 40;
  const auto typical_error = [&](int views) {
    Eigen::Vector2d squared(0.0, 0.0);
    for (int run = 0; run < kRuns; ++run) {
      const Isometry3d X_BC = RandomMounting(random);
      const PoseMean estimated = FindCameraMounting(Views(X_BC, views, 1.0, random));
      squared +=
          Eigen::Vector2d((estimated.X_AB.translation() - X_BC.translation()).squaredNorm(),
                          models::RotationLog(estimated.X_AB.linear() * X_BC.linear().transpose()).squaredNorm());
    }
    return Eigen::Vector2d((squared / kRuns).cwiseSqrt());
  };
  const Eigen::Vector2d few = typical_error(4), many = typical_error(64);
  EXPECT_NEAR(few.x() / many.x(), 4.0, 1.5);
  EXPECT_NEAR(few.y() / many.y(), 4.0, 1.5);
  EXPECT_LT(many.x(), 0.003);
}

TEST(CameraMounting, RequiresAView) { EXPECT_THROW(FindCameraMounting({}), InputError); }

}  // namespace
}  // namespace touchdown::estimator::calibration
