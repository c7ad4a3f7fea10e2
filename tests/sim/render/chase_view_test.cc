#include "sim/render/chase_view.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "models/angles.h"
#include "models/camera_model.h"
#include "sim/dynamics/world.h"
#include "sim/render/renderer.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tests::LevelPose;

std::unique_ptr<World> PaintedWorld() {
  return std::make_unique<World>(WorldConfig{}, models::Vehicle{}, tests::EmptyRoom(), models::TimeBase{}, 1);
}

/// Pixel of a point in the newest image.
Vector2d PixelOf(const ChaseView& chase, const Vector3d& p_W) {
  const PinholeView& view = chase.view();
  const models::CameraModel pinhole{.width_px = view.width_px,
                                    .height_px = view.height_px,
                                    .fx_px = view.focal_px,
                                    .fy_px = view.focal_px,
                                    .cx_px = view.cx_px,
                                    .cy_px = view.cy_px,
                                    .k1 = 0.0,
                                    .k2 = 0.0};
  return pinhole.Project(chase.X_WC().inverse() * p_W).value();
}

/// Mean pixel of the hull's red paint.
Vector2d MeanRedPixel(const cv::Mat3b& image) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const cv::Vec3b& bgr = image(v, u);
      if (bgr[2] < 2.5 * bgr[1] || bgr[2] < 80) continue;
      sum += Vector2d(u, v);
      ++count;
    }
  }
  EXPECT_GT(count, 2);
  return sum / std::max(1, count);
}

const std::vector<Vector3d>& Positions() {
  static const std::vector<Vector3d> positions = {{0.0, 0.0, 0.14}, {0.1, -0.1, 0.5}, {0.0, 0.0, 1.0},
                                                  {0.0, 0.0, 3.0},  {1.5, 0.0, 1.0},  {-1.5, 1.0, 0.8},
                                                  {0.5, 3.0, 2.0},  {-3.0, -3.0, 1.0}};
  return positions;
}

TEST(ChaseView, ShowsTheVehicleAtItsProjectedPosition) {
  const auto world = PaintedWorld();
  ChaseView chase(world->model(), {});
  for (const Vector3d& p_WB : Positions()) {
    const cv::Mat3b& image = chase.Render(LevelPose(p_WB.x(), p_WB.y(), p_WB.z()), false);
    // The hull is 0.13 m long; its far sides and its back are not visible.
    const double px_per_m = chase.view().focal_px / (chase.X_WC().inverse() * p_WB).z();
    EXPECT_LT((MeanRedPixel(image) - PixelOf(chase, p_WB)).norm(), 3.0 + 0.05 * px_per_m) << p_WB.transpose();
  }
}

TEST(ChaseView, KeepsVehicleAndPadInView) {
  const auto world = PaintedWorld();
  ChaseView chase(world->model(), {});
  for (const Vector3d& p_WB : Positions()) {
    chase.Render(LevelPose(p_WB.x(), p_WB.y(), p_WB.z()), false);
    for (int i = 0; i < 12; ++i) {
      const Vector3d around(std::cos(i * models::kPi / 6), std::sin(i * models::kPi / 6), 0.0);
      for (const Vector3d& p_W : {Vector3d(0.15 * around), Vector3d(p_WB + 0.33 * around)}) {
        const Vector2d pixel = PixelOf(chase, p_W);
        EXPECT_GT(pixel.minCoeff(), 0.0) << p_WB.transpose();
        EXPECT_LT(pixel.maxCoeff(), 479.0) << p_WB.transpose();
      }
    }
  }
}

TEST(ChaseView, IsAtRestInAHoverAndFollowsSmoothly) {
  const auto world = PaintedWorld();
  ChaseView chase(world->model(), {});
  constexpr double kStep_m = 0.05;
  double path_m = 0.0;
  chase.Render(LevelPose(0.0, 0.0, 1.0), false);
  for (int step = 1; step <= 40; ++step) {
    const Vector3d before = chase.X_WC().translation();
    chase.Render(LevelPose(step * kStep_m, 0.0, 1.0), false);
    const double moved_m = (chase.X_WC().translation() - before).norm();
    if (step * kStep_m < 0.149) {
      EXPECT_EQ(moved_m, 0.0);
    }
    EXPECT_LT(moved_m, 2.0 * kStep_m);
    path_m += moved_m;
  }
  EXPECT_GT(path_m, 0.5 * (2.0 - 0.15)) << "the midpoint of pad and vehicle moves by half as much as the vehicle";
}

TEST(ChaseView, ShowsThePadBareAndCovered) {
  const auto world = PaintedWorld();
  ChaseView chase(world->model(), {});
  const Eigen::Isometry3d X_WB = LevelPose(1.0, 0.0, 1.0);
  chase.Render(X_WB, false);
  const Vector2d ring = PixelOf(chase, {0.082, 0.0, 0.0});
  const cv::Point pixel(static_cast<int>(std::lround(ring.x())), static_cast<int>(std::lround(ring.y())));
  EXPECT_LT(chase.Render(X_WB, false)(pixel)[1], 120);
  EXPECT_GT(chase.Render(X_WB, true)(pixel)[1], 190);
  EXPECT_LT(chase.Render(X_WB, false)(pixel)[1], 120);
}

TEST(ChaseView, IsInColor) {
  const auto world = PaintedWorld();
  ChaseView chase(world->model(), {});
  const Vector3d p_WB(0.0, 0.0, 1.0);
  const cv::Mat3b& image = chase.Render(LevelPose(0.0, 0.0, 1.0), false);
  // The front rotors are orange: more red than green, more green than blue.
  const Vector2d rotor = PixelOf(chase, p_WB + models::Vehicle{}.RotorPosition(0) + Vector3d(0.05, 0.0, 0.0));
  const cv::Vec3b bgr = image(static_cast<int>(std::lround(rotor.y())), static_cast<int>(std::lround(rotor.x())));
  EXPECT_GT(bgr[2], bgr[1] + 10);
  EXPECT_GT(bgr[1], bgr[0] + 10);
}

TEST(ChaseView, DoesNotAffectTheOnboardCameraOrTheWorld) {
  const auto world = PaintedWorld();
  Renderer onboard(world->model(), {});
  const Eigen::Isometry3d X_WC = LevelPose(0.0, 0.0, 1.0) * models::Vehicle{}.X_BC();
  const models::Image alone = onboard.Render(world->data(), X_WC);
  const TrueState before = world->state();
  ChaseView chase(world->model(), {});
  chase.Render(LevelPose(0.3, 0.2, 1.0), true);
  EXPECT_EQ(onboard.Render(world->data(), X_WC).pixels, alone.pixels);
  EXPECT_EQ(world->state().X_WB.matrix(), before.X_WB.matrix());
}

}  // namespace
}  // namespace touchdown::sim
