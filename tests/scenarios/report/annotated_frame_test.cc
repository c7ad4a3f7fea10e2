#include "scenarios/report/annotated_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "models/vehicle.h"

namespace touchdown::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using estimator::Overlay;
using Role = Overlay::Role;

const models::Image& Gray() {
  static const models::Image image(640, 480, 128);
  return image;
}

enum Color { kBlue, kGreen, kRed };

/// Dominant color of a pixel.
Color ColorAt(const cv::Mat3b& image, const Vector2d& pixel) {
  const cv::Vec3b& bgr = image(static_cast<int>(std::lround(pixel.y())), static_cast<int>(std::lround(pixel.x())));
  return static_cast<Color>(std::max_element(bgr.val, bgr.val + 3) - bgr.val);
}

bool IsUntouched(const cv::Mat3b& image, const Vector2d& pixel) {
  return image(static_cast<int>(pixel.y()), static_cast<int>(pixel.x())) == cv::Vec3b(128, 128, 128);
}

TEST(AnnotateFrame, DrawsBoxesInRoleColorsAndCrossOnPad) {
  FrameAnnotation annotation;
  annotation.overlay.boxes = {{{100, 100, 50, 50}, Role::kOutline, "circle", 1.0},
                              {{200, 100, 50, 50}, Role::kMarking, "h", 1.0},
                              {{300, 100, 50, 50}, Role::kOther, "other", 1.0}};
  annotation.pad_px = Vector2d(500, 300);
  const cv::Mat3b image = AnnotateFrame(Gray().View(), {}, annotation);
  EXPECT_EQ(ColorAt(image, {125, 100}), kGreen);
  EXPECT_EQ(ColorAt(image, {225, 100}), kBlue);
  EXPECT_EQ(ColorAt(image, {325, 100}), kRed);
  const cv::Vec3b& orange = image(300, 500);
  EXPECT_GT(orange[2], orange[1]);
  EXPECT_GT(orange[1], orange[0]);
  EXPECT_TRUE(IsUntouched(image, {600, 400}));
  EXPECT_TRUE(IsUntouched(image, {5, 5}));
}

TEST(AnnotateFrame, DrawsEllipsesWithAxesAtDistortedPixels) {
  const models::CameraModel camera;
  const double angle = 0.5;
  const Overlay::Ellipse ellipse{
      .center = {480, 120}, .semi_axes = {80, 40}, .angle = angle, .role = Role::kFit, .name = "ring_outer"};
  FrameAnnotation annotation;
  annotation.overlay.ellipses = {ellipse};
  const cv::Mat3b image = AnnotateFrame(Gray().View(), camera, annotation);
  const Vector2d along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  const auto raw = [&](const Vector2d& undistorted) {
    return camera.PixelFromNormalized(camera.Distort(camera.NormalizedFromPixel(undistorted)));
  };
  for (const Vector2d& end : {Vector2d(80 * along), Vector2d(-80 * along), Vector2d(40 * across)}) {
    for (const double fraction : {0.98, 0.5}) {
      const Vector2d pixel = raw(ellipse.center + fraction * end);
      const cv::Rect around(static_cast<int>(std::lround(pixel.x())) - 1, static_cast<int>(std::lround(pixel.y())) - 1,
                            3, 3);
      int yellow = 0;
      for (const cv::Vec3b& bgr : cv::Mat3b(image(around).clone())) yellow += std::min(bgr[1], bgr[2]) > bgr[0] + 60;
      EXPECT_GE(yellow, 2) << pixel.transpose();
    }
  }
  EXPECT_TRUE(IsUntouched(image, raw(ellipse.center + 40 * along + 15 * across)));
}

TEST(AnnotateFrame, DrawsProjectedAxesOfWorldFrame) {
  const models::CameraModel camera{.k1 = -0.2};
  Eigen::Isometry3d X_WB(Eigen::AngleAxisd(0.4, Vector3d(0.3, 1.0, 0.2).normalized()));
  X_WB.translation() << 0.2, -0.15, 0.5;
  const Eigen::Isometry3d X_WC = X_WB * models::Vehicle().X_BC();
  const cv::Mat3b image = AnnotateFrame(Gray().View(), camera, {.overlay = {}, .pad_px = {}, .X_WC = X_WC});
  for (const auto& [axis, color] : {std::pair(0, kRed), std::pair(1, kGreen), std::pair(2, kBlue)}) {
    const Vector2d origin = camera.Project(X_WC.inverse() * Vector3d::Zero()).value();
    const Vector2d tip = camera.Project(X_WC.inverse() * Vector3d(0.09 * Vector3d::Unit(axis))).value();
    ASSERT_GT((tip - origin).norm(), 10.0);
    EXPECT_EQ(ColorAt(image, 0.3 * origin + 0.7 * tip), color) << axis;
    EXPECT_FALSE(IsUntouched(image, 0.3 * origin + 0.7 * tip));
    EXPECT_TRUE(IsUntouched(image, tip + 0.3 * (tip - origin))) << axis;
  }
}

TEST(AnnotateFrame, OmitsAxesThatCannotBeProjected) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();  // The origin of W is at the camera or behind it.
  for (const double z : {0.0, 0.5, -1e-9}) {
    X_WC.translation().z() = z;
    const cv::Mat3b image = AnnotateFrame(Gray().View(), {}, {.overlay = {}, .pad_px = {}, .X_WC = X_WC});
    EXPECT_TRUE(IsUntouched(image, {400, 300})) << z;
  }
}

TEST(AnnotateFrame, DrawsPolylinesAndLabels) {
  FrameAnnotation annotation;
  annotation.overlay.polylines = {{{{100, 100}, {200, 100}, {200, 200}}, false, Role::kOutline, "tag"},
                                  {{{300, 100}, {400, 100}, {400, 200}}, true, Role::kFit, "tag"}};
  annotation.overlay.labels = {{{100, 300}, "tag 17", Role::kMarking}};
  const cv::Mat3b image = AnnotateFrame(Gray().View(), {}, annotation);
  EXPECT_EQ(ColorAt(image, {150, 100}), kGreen);
  EXPECT_EQ(ColorAt(image, {200, 150}), kGreen);
  EXPECT_TRUE(IsUntouched(image, {150, 150}));
  EXPECT_FALSE(IsUntouched(image, {350, 150})) << "a closed polyline";
  const cv::Mat3b text = image(cv::Rect(95, 280, 80, 30)).clone();
  EXPECT_GT(cv::countNonZero(text.reshape(1) != 128), 100);
}

TEST(AnnotateFrame, DrawsMarkingsOverOtherBoxes) {
  FrameAnnotation annotation;
  annotation.overlay.boxes = {{{100, 100, 50, 50}, Role::kMarking, "h", 1.0},
                              {{100, 100, 50, 50}, Role::kOther, "other", 1.0}};
  EXPECT_EQ(ColorAt(AnnotateFrame(Gray().View(), {}, annotation), {125, 100}), kBlue);
}

TEST(AnnotateFrame, ScalesLineWidthWithFrameSize) {
  for (const auto& [width, height, expected_px] : {std::tuple(320, 240, 1), std::tuple(4000, 3000, 13)}) {
    const models::Image image(width, height, 128);
    models::CameraModel camera{.width_px = width, .height_px = height};
    FrameAnnotation annotation;
    annotation.overlay.boxes = {{{width / 4, height / 4, width / 2, height / 2}, Role::kOutline, "circle", 1.0}};
    const cv::Mat3b annotated = AnnotateFrame(image.View(), camera, annotation);
    int line_px = 0;
    for (int v = 0; v < height / 2; ++v) line_px += annotated(v, width / 2) != cv::Vec3b(128, 128, 128);
    EXPECT_NEAR(line_px, expected_px, 0.2 * expected_px) << width;
  }
}

TEST(DrawCaption, DrawsTextOnlyIntoStrip) {
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(320, 240), std::pair(40, 4000), std::pair(1, 1)}) {
    cv::Mat3b image(height, width, cv::Vec3b(128, 128, 128));
    const int strip_px = CaptionHeight(image.size());
    DrawCaption(image.rowRange(0, strip_px), "12.34 s  landing", CaptionColor(estimator::FrameStatus::kNotFound));
    if (height > strip_px) {
      EXPECT_EQ(cv::countNonZero(image.rowRange(strip_px, height).reshape(1) != 128), 0);
    }
    if (width < 100) continue;
    EXPECT_EQ(image(0, 0), cv::Vec3b(0, 0, 0));
    double blue = 0.0, red = 0.0;
    for (const cv::Vec3b& bgr : cv::Mat3b(image.rowRange(0, strip_px).clone())) blue += bgr[0], red += bgr[2];
    EXPECT_GT(red, 10.0 * width);
    EXPECT_LT(blue, 0.2 * red) << "a frame without a pose has a yellow caption";
  }
}

}  // namespace
}  // namespace touchdown::report
