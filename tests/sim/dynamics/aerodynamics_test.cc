#include "sim/dynamics/aerodynamics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace touchdown::sim {
namespace {

TEST(DragForce, IsZeroInStillAir) {
  EXPECT_EQ(DragForce(models::Vehicle{}, Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero());
}

TEST(DragForce, AddsALinearAndAQuadraticPartOnEachAxis) {
  models::Vehicle vehicle;
  vehicle.linear_drag_n_s_m = {0.1, 0.2, 0.3};
  vehicle.quadratic_drag_n_s2_m2 = {0.01, 0.02, 0.03};
  const Eigen::Vector3d along_x = DragForce(vehicle, {2.0, 0.0, 0.0});
  EXPECT_TRUE(along_x.isApprox(Eigen::Vector3d(-0.24, 0.0, 0.0), 1e-12));
  const Eigen::Vector3d oblique = DragForce(vehicle, {2.0, -1.0, 2.0});
  EXPECT_TRUE(oblique.isApprox(Eigen::Vector3d(-0.26, 0.26, -0.78), 1e-12));
}

TEST(DragForce, AlwaysDissipatesEnergy) {
  const models::Vehicle vehicle;
  for (double angle = 0.0; angle < 6.3; angle += 0.3) {
    for (const double speed : {0.01, 1.0, 30.0}) {
      const Eigen::Vector3d v = speed * Eigen::Vector3d(std::cos(angle), std::sin(angle), std::sin(3.0 * angle));
      EXPECT_LT(DragForce(vehicle, v).dot(v), 0.0);
      EXPECT_TRUE(DragForce(vehicle, -v).isApprox(-DragForce(vehicle, v), 1e-12));
    }
  }
}

}  // namespace
}  // namespace touchdown::sim
