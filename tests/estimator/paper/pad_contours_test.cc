#include "estimator/paper/pad_contours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "estimator/paper/binarize.h"
#include "models/angles.h"
#include "models/error.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Scene {
  models::CameraModel camera;
  models::LandingPad pad;
  Eigen::Isometry3d X_WC;
  models::Image image;
  ComponentSet components;
  DetectedPad detected;

  /// The point of the pad's plane at a raw pixel, in W, m.
  Vector2d OnPad(const Vector2d& pixel) const {
    const Vector3d ray_W = X_WC.linear() * *camera.Ray(pixel);
    return (X_WC.translation() - X_WC.translation().z() / ray_W.z() * ray_W).head<2>();
  }

  /// Signed distance of a raw pixel from the image of a circle of the given radius, px; positive outside.
  double DistanceFromCircle_px(const Vector2d& pixel, double radius_m) const {
    const Vector2d p_W = OnPad(pixel), on_circle = p_W.normalized() * radius_m;
    const auto nearest = camera.Project(X_WC.inverse() * Vector3d(on_circle.x(), on_circle.y(), 0.0));
    return std::copysign((pixel - *nearest).norm(), p_W.norm() - radius_m);
  }
};

Scene SceneFrom(const Eigen::Isometry3d& X_WC, const tests::PadAppearance& appearance = {},
                const models::LandingPad& pad = {}) {
  Scene scene{.camera = {}, .pad = pad, .X_WC = X_WC, .image = {}, .components = {}, .detected = {}};
  models::RandomStream random(1, "tests.edges");
  scene.image = tests::RenderPad(scene.camera, scene.pad, X_WC, appearance, &random);
  scene.components = ExtractComponents(Binarize(scene.image.View()).View());
  const Vector2d center = *scene.camera.Project(X_WC.inverse() * Vector3d::Zero());
  const double radius_px = scene.camera.fx_px * scene.pad.outer_radius_m / X_WC.translation().norm();
  for (const Component& component : scene.components.components) {
    const Vector2d offset =
        Vector2d(component.u + component.width / 2.0, component.v + component.height / 2.0) - center;
    const int side = std::max(component.width, component.height);
    if (offset.norm() > 0.3 * radius_px || side > 2.6 * radius_px) continue;
    (side > 1.5 * radius_px ? scene.detected.ring : scene.detected.letter) = component;
  }
  EXPECT_GT(scene.detected.ring.area, 0);
  EXPECT_GT(scene.detected.letter.area, 0);
  return scene;
}

pad::PadContours Contours(const Scene& scene, pad::ContourPoints points) {
  return FindContours(scene.image.View(), scene.components, scene.detected, scene.pad, {.contour_points = points});
}

double RmsFromCircle_px(const Scene& scene, const std::vector<Vector2d>& points, double radius_m) {
  double sum = 0.0;
  for (const Vector2d& point : points) sum += std::pow(scene.DistanceFromCircle_px(point, radius_m), 2);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

const Eigen::Isometry3d kOblique = [] {
  Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), 0.4, models::DegToRad(25.0), 1.0);
  X_WC.translation() = -X_WC.linear().col(2) * 0.7 + Vector3d(0.03, 0.02, 0.0);
  return X_WC;
}();

TEST(Edges, AreAssignedToTheThreeContours) {
  for (const auto& X_WC : {tests::CameraAbovePad({0.0, 0.0, 0.3}), tests::CameraAbovePad({0.1, 0.0, 1.0}),
                           tests::CameraAbovePad({0.0, 0.1, 1.8}), kOblique}) {
    const Scene scene = SceneFrom(X_WC, {.noise_sigma = 3.0});
    for (const pad::ContourPoints kind : {pad::ContourPoints::kInteger, pad::ContourPoints::kSubpixel}) {
      const pad::PadContours contours = Contours(scene, kind);
      const double circumference_px =
          2.0 * models::kPi * scene.pad.outer_radius_m * scene.camera.fx_px / X_WC.translation().norm();
      EXPECT_GT(static_cast<double>(contours.ring_outer.size()), 0.7 * circumference_px);
      EXPECT_GT(static_cast<double>(contours.ring_inner.size()), 0.5 * circumference_px);
      EXPECT_GT(contours.letter.size(), contours.ring_inner.size() / 2);
      for (const Vector2d& point : contours.ring_outer) {
        EXPECT_LT(std::abs(scene.DistanceFromCircle_px(point, scene.pad.outer_radius_m)), 1.5);
      }
      for (const Vector2d& point : contours.ring_inner) {
        EXPECT_LT(std::abs(scene.DistanceFromCircle_px(point, scene.pad.inner_radius_m())), 1.5);
      }
      for (const Vector2d& point : contours.letter) EXPECT_LT(scene.OnPad(point).norm(), 0.066);
    }
  }
}

TEST(Edges, HaveSubpixelAccuracy) {
  for (const double height : {0.5, 1.0, 1.5}) {
    const Scene scene = SceneFrom(tests::CameraAbovePad({0.05, 0.03, height}, 0.2), {.noise_sigma = 3.0});
    const double radius = scene.pad.outer_radius_m;
    const double integer = RmsFromCircle_px(scene, Contours(scene, pad::ContourPoints::kInteger).ring_outer, radius);
    const double subpixel = RmsFromCircle_px(scene, Contours(scene, pad::ContourPoints::kSubpixel).ring_outer, radius);
    EXPECT_GT(integer, 0.2);
    EXPECT_LT(integer, 0.5);
    EXPECT_LT(subpixel, 0.1);
  }
}

TEST(Edges, HaveSubpixelAccuracyForARingOfTwoPixelsWidth) {
  for (const double height : {2.5, 2.8, 3.1}) {
    const Scene scene =
        SceneFrom(tests::CameraAbovePad({0.05, 0.03, height}, 0.2), {.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5});
    const double radius = scene.pad.outer_radius_m;
    const double integer = RmsFromCircle_px(scene, Contours(scene, pad::ContourPoints::kInteger).ring_outer, radius);
    const double subpixel = RmsFromCircle_px(scene, Contours(scene, pad::ContourPoints::kSubpixel).ring_outer, radius);
    EXPECT_LT(subpixel, 0.4 * integer) << height;
    EXPECT_LT(subpixel, 0.13) << height;
  }
}

TEST(Edges, AreNotShiftedByTheOtherStrokeOfANarrowH) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.024;  // The strokes are 8 mm apart.
  for (const double height : {0.4, 0.7, 1.0}) {
    const Scene scene = SceneFrom(tests::CameraAbovePad({0.0, 0.0, height}, 0.2), {}, pad);
    const double px_per_m = scene.camera.fx_px / height;
    int between_strokes = 0;
    for (const Vector2d& point : Contours(scene, pad::ContourPoints::kSubpixel).letter) {
      const Vector2d p = scene.OnPad(point).cwiseAbs();
      if (p.x() < 0.018 || p.x() > 0.044 || p.y() > 0.012) continue;
      ++between_strokes;
      EXPECT_NEAR(p.y() * px_per_m, 0.004 * px_per_m, 0.1) << height;
    }
    EXPECT_GT(between_strokes, 0.8 * 4 * 0.026 * px_per_m) << height;
  }
}

TEST(Edges, AreNotShiftedByBlur) {
  for (const double blur : {0.5, 1.0}) {
    const Scene scene = SceneFrom(tests::CameraAbovePad({0.05, 0.03, 0.7}, 0.2), {.lens_blur_sigma_px = blur});
    double mean = 0.0;
    const auto points = Contours(scene, pad::ContourPoints::kSubpixel).ring_outer;
    for (const Vector2d& point : points) mean += scene.DistanceFromCircle_px(point, scene.pad.outer_radius_m);
    EXPECT_LT(std::abs(mean / static_cast<double>(points.size())), 0.05);
  }
}

TEST(Edges, StayInsideTheImageWhenItCutsTheRing) {
  const Scene scene = [] {
    Scene cut = SceneFrom(tests::CameraAbovePad({0.0, 0.0, 0.14}));
    return cut;
  }();
  for (const pad::ContourPoints kind : {pad::ContourPoints::kInteger, pad::ContourPoints::kSubpixel}) {
    const pad::PadContours contours = Contours(scene, kind);
    EXPECT_FALSE(contours.ring_outer.empty());
    for (const auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
      for (const Vector2d& point : *contour) EXPECT_TRUE(scene.camera.Contains(point));
    }
  }
}

TEST(EdgeConfig, RejectsInvalidSettings) {
  EXPECT_THROW((pad::EdgeConfig{.canny_low = 100.0, .canny_high = 50.0}.Validate()), InputError);
  EXPECT_THROW((pad::EdgeConfig{.canny_low = -1.0}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::paper
