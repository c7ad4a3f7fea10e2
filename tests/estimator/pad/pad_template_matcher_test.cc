#include "estimator/pad/pad_template_matcher.h"

#include <gtest/gtest.h>

#include <functional>

#include "models/angles.h"
#include "models/error.h"
#include "models/pad_outline.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;
using models::LandingPad;

struct Artwork : LandingPad {
  explicit Artwork(const LandingPad& pad) : LandingPad(pad), outline(pad) {}
  models::PadOutline outline;
};

/// Whether a point within the ring is black.
using Black = std::function<bool(const Artwork&, const Vector2d&)>;

bool OnStrokes(const LandingPad& pad, const Vector2d& p) {
  const Vector2d q = p.cwiseAbs();
  return q.x() < pad.h_height_m / 2 && q.y() < pad.h_width_m / 2 && q.y() > pad.h_width_m / 2 - pad.h_stroke_m;
}

struct View {
  double distance = 0.5, tilt_deg = 20.0, noise_sigma = 3.0, lens_blur_sigma_px = 0.7;
  std::function<double(double gray, const Vector2d& p_W)> light = nullptr;
};

class PadTemplateMatcherTest : public testing::Test {
 protected:
  void SetView(const View& view) {
    X_WC_ = tests::CameraAbovePad(Eigen::Vector3d::Zero(), kYaw, models::DegToRad(view.tilt_deg), 1.0);
    X_WC_.translation() = -view.distance * X_WC_.linear().col(2);
  }

  /// Renders a ring with the artwork `black` and searches the template, given the true pose of the ring.
  std::optional<TemplateWarp> Find(const Black& black, const View& view = {}) {
    SetView(view);
    tests::PadAppearance appearance{
        .noise_sigma = view.noise_sigma, .lens_blur_sigma_px = view.lens_blur_sigma_px, .letter = false};
    const Artwork pad(pad_);
    appearance.paint = [&](const Vector2d& p) -> std::optional<double> {
      if (p.norm() > 0.1) return std::nullopt;
      const bool is_black = p.norm() > pad_.inner_radius_m() ? pad.outline.IsBlack(p) : black(pad, p);
      const double gray = is_black ? appearance.black : appearance.paper;
      return view.light ? view.light(gray, p) : gray;
    };
    models::RandomStream noise(7, "noise");
    const models::Image image = tests::RenderPad(camera_, pad_, X_WC_, appearance, &noise);
    const Eigen::Isometry3d X_CW = X_WC_.inverse();
    const CirclePose pose{X_CW.linear().col(2), X_CW.translation()};
    const DownsampledCamera camera{camera_, undistort_, 1};
    const auto match = PadTemplateMatcher(pad_).Find(image.View(), PadPlane(pose, camera));
    return match ? std::optional(match->warp) : std::nullopt;
  }

  /// Error of the estimated direction of W's X axis, modulo 180 degrees, rad.
  double AngleError(const TemplateWarp& warp) const {
    const Eigen::Isometry3d X_CW = X_WC_.inverse();
    const CirclePose pose{X_CW.linear().col(2), X_CW.translation()};
    const DownsampledCamera camera{camera_, undistort_, 1};
    const PadPlane plane(pose, camera);
    const Eigen::Vector3d origin = plane.InCamera({0, 0}), x = plane.InCamera({1, 0}) - origin,
                          y = plane.InCamera({0, 1}) - origin, along = X_CW.linear().col(0);
    return std::abs(models::WrapToHalfPi(warp.angle - std::atan2(along.dot(y), along.dot(x))));
  }

  static constexpr double kYaw = 0.4;
  models::CameraModel camera_;
  LandingPad pad_;
  UndistortTable undistort_{camera_};
  Eigen::Isometry3d X_WC_;
};

const Black kDescribed = [](const Artwork& pad, const Vector2d& p) { return pad.outline.IsBlack(p); };

TEST_F(PadTemplateMatcherTest, FindsTheHAndItsDirectionFromAnyDistanceAndTilt) {
  for (const View& view : {View{.distance = 0.25, .tilt_deg = 0.0}, View{.distance = 0.5, .tilt_deg = 30.0},
                           View{.distance = 0.5, .tilt_deg = 55.0}, View{.distance = 1.8, .tilt_deg = 10.0}}) {
    const auto warp = Find(kDescribed, view);
    ASSERT_TRUE(warp) << view.distance << " m, " << view.tilt_deg;
    EXPECT_LT(AngleError(*warp), models::DegToRad(view.distance < 1.0 ? 1.0 : 3.0)) << view.distance;
    EXPECT_LT(warp->offset_m.norm(), 0.004);
    EXPECT_NEAR(warp->scale.x(), 1.0, 0.05);
    EXPECT_NEAR(warp->scale.y(), 1.0, 0.05);
  }
}

TEST_F(PadTemplateMatcherTest, RejectsOtherLetters) {
  const Black letter_n = [](const Artwork& pad, const Vector2d& p) {
    const double half_x = pad.h_height_m / 2, half_y = pad.h_width_m / 2 - pad.h_stroke_m / 2;
    const bool diagonal = std::abs(p.x()) < half_x && std::abs(p.y() - p.x() / half_x * half_y) < pad.h_stroke_m / 2;
    return OnStrokes(pad, p) || diagonal;
  };
  const Black letter_u = [](const Artwork& pad, const Vector2d& p) {
    const bool base = p.x() > -pad.h_height_m / 2 && p.x() < -pad.h_height_m / 2 + pad.h_stroke_m;
    return OnStrokes(pad, p) || (base && std::abs(p.y()) < pad.h_width_m / 2);
  };
  const Black two_strokes = [](const Artwork& pad, const Vector2d& p) { return OnStrokes(pad, p); };
  const Black eight = [](const Artwork& pad, const Vector2d& p) {
    const Vector2d q = p.cwiseAbs();
    const bool ends = q.x() < pad.h_height_m / 2 && q.x() > pad.h_height_m / 2 - pad.h_stroke_m;
    return pad.outline.IsBlack(p) || (ends && q.y() < pad.h_width_m / 2);
  };
  const Black cross = [](const Artwork& pad, const Vector2d& p) {
    const Vector2d q = p.cwiseAbs();
    return q.minCoeff() < pad.h_stroke_m / 2 && q.maxCoeff() < pad.h_height_m / 2;
  };
  const Black nothing = [](const Artwork&, const Vector2d&) { return false; };
  for (const double distance : {0.3, 0.8, 1.5}) {
    for (const Black& artwork : {letter_n, letter_u, two_strokes, eight, cross, nothing}) {
      EXPECT_FALSE(Find(artwork, {.distance = distance})) << distance;
    }
  }
}

TEST_F(PadTemplateMatcherTest, RejectsAnHOfWrongSizeOrPosition) {
  EXPECT_FALSE(Find([](const Artwork& pad, const Vector2d& p) { return pad.outline.IsLetter(p / 0.7); }));
  EXPECT_FALSE(Find([](const Artwork& pad, const Vector2d& p) { return pad.outline.IsLetter(p / 1.3); }));
  EXPECT_FALSE(
      Find([](const Artwork& pad, const Vector2d& p) { return pad.outline.IsLetter(p - Vector2d(0.0, 0.02)); }));
}

TEST_F(PadTemplateMatcherTest, FindsAnHBrokenByGlare) {
  const auto glare = [](double gray, const Vector2d& p) {
    return (p - Vector2d(0.032, 0.02)).norm() < 0.012 ? 225.0 : gray;
  };
  const auto warp = Find(kDescribed, {.light = glare});
  ASSERT_TRUE(warp);
  EXPECT_LT(AngleError(*warp), models::DegToRad(2.0));
}

TEST_F(PadTemplateMatcherTest, FindsAnHPartlyInShadow) {
  const auto shadow = [](double gray, const Vector2d& p) { return p.x() + p.y() > 0.01 ? 0.5 * gray : gray; };
  EXPECT_TRUE(Find(kDescribed, {.light = shadow}));
}

TEST_F(PadTemplateMatcherTest, FindsASquareHAndItsDirection) {
  pad_.h_height_m = pad_.h_width_m = 0.08;
  const auto warp = Find(kDescribed);
  ASSERT_TRUE(warp);
  EXPECT_LT(AngleError(*warp), models::DegToRad(1.0));
}

TEST_F(PadTemplateMatcherTest, MatchesAtTheTrueOrientationOnly) {
  SetView({});
  const models::Image image = tests::RenderPad(camera_, pad_, X_WC_);
  const Eigen::Isometry3d X_CW = X_WC_.inverse();
  const DownsampledCamera camera{camera_, undistort_, 1};
  const PadPlane plane({X_CW.linear().col(2), X_CW.translation()}, camera);
  const PadTemplateMatcher matcher(pad_);
  const auto match = matcher.Find(image.View(), plane);
  ASSERT_TRUE(match);
  EXPECT_GT(match->zncc, 0.9);
  const double angle = match->warp.angle;
  const auto rotated = [&](double angle_deg) { return TemplateWarp{.angle = angle + models::DegToRad(angle_deg)}; };
  for (const double angle_deg : {0.0, 3.0, -3.0, 180.0}) {
    EXPECT_TRUE(matcher.MatchesAt(image.View(), plane, std::vector{rotated(angle_deg)})) << angle_deg;
  }
  for (const double angle_deg : {25.0, -25.0, 90.0}) {
    EXPECT_FALSE(matcher.MatchesAt(image.View(), plane, std::vector{rotated(angle_deg)})) << angle_deg;
  }
  EXPECT_TRUE(matcher.MatchesAt(image.View(), plane, std::vector{rotated(90.0), rotated(0.0)}));
  EXPECT_FALSE(matcher.MatchesAt(image.View(), plane, std::vector{rotated(90.0), rotated(25.0)}));
  EXPECT_FALSE(matcher.MatchesAt(image.View(), plane, {}));
}

TEST_F(PadTemplateMatcherTest, FindsAPadWithMarkingsAllAroundTheRing) {
  for (int i = 0; i < 10; ++i) {
    const double angle = 2.0 * models::kPi * i / 10.0;
    pad_.marks.push_back({.center_m = 0.064 * Vector2d(std::cos(angle), std::sin(angle)), .diameter_m = 0.014});
  }
  pad_.Validate();
  EXPECT_TRUE(Find(kDescribed));
}

TEST_F(PadTemplateMatcherTest, FindsThinThickAndWideHs) {
  const LandingPad nominal = pad_;
  pad_.h_stroke_m = 0.0025;
  EXPECT_TRUE(Find(kDescribed, {.distance = 0.25, .noise_sigma = 0.0, .lens_blur_sigma_px = 0.3})) << "thin";
  pad_.h_stroke_m = 0.026;
  EXPECT_TRUE(Find(kDescribed, {.distance = 0.25})) << "thick";
  pad_ = nominal;
  std::swap(pad_.h_height_m, pad_.h_width_m);
  EXPECT_TRUE(Find(kDescribed)) << "wide";
  pad_ = nominal;
  pad_.ring_width_m = 0.003;
  EXPECT_TRUE(Find(kDescribed)) << "in a thin ring";
}

TEST_F(PadTemplateMatcherTest, FindsARectangleAndItsDirection) {
  pad_.h_stroke_m = 0.5 * pad_.h_width_m;
  for (const View& view : {View{.distance = 0.25, .tilt_deg = 0.0}, View{.distance = 0.5, .tilt_deg = 30.0},
                           View{.distance = 0.5, .tilt_deg = 55.0}, View{.distance = 1.8, .tilt_deg = 10.0}}) {
    const auto warp = Find(kDescribed, view);
    ASSERT_TRUE(warp) << view.distance << " m, " << view.tilt_deg;
    EXPECT_LT(AngleError(*warp), models::DegToRad(view.distance < 1.0 ? 1.0 : 3.0)) << view.distance;
  }
}

TEST_F(PadTemplateMatcherTest, RejectsShapesOtherThanASolidRectangle) {
  pad_.h_stroke_m = 0.5 * pad_.h_width_m;
  LandingPad thick;
  thick.h_stroke_m = 0.34 * thick.h_width_m;
  const Black h = [nominal = models::PadOutline({})](const Artwork&, const Vector2d& p) { return nominal.IsLetter(p); };
  const Black thick_h = [outline = models::PadOutline(thick)](const Artwork&, const Vector2d& p) {
    return outline.IsLetter(p);
  };
  const Black frame = [](const Artwork& pad, const Vector2d& p) {
    return pad.outline.IsLetter(p) && !pad.outline.IsLetter(p / 0.7);
  };
  const Black ellipse = [](const Artwork& pad, const Vector2d& p) {  // Same area as the rectangle.
    return p.cwiseQuotient(Vector2d(pad.h_height_m, pad.h_width_m)).norm() < 1.0 / std::sqrt(models::kPi);
  };
  const Black disc = [](const Artwork&, const Vector2d& p) { return p.norm() < 0.042; };
  const Black triangle = [](const Artwork& pad, const Vector2d& p) {
    const double fraction = (p.x() / pad.h_height_m + 0.5);
    return fraction > 0.0 && fraction < 1.0 && std::abs(p.y()) < pad.h_width_m * fraction;
  };
  const Black nothing = [](const Artwork&, const Vector2d&) { return false; };
  for (const double distance : {0.3, 0.8, 1.5}) {
    int i = 0;
    for (const Black& artwork : {h, thick_h, frame, ellipse, disc, triangle, nothing}) {
      EXPECT_FALSE(Find(artwork, {.distance = distance})) << distance << " " << i;
      ++i;
    }
  }
}

TEST_F(PadTemplateMatcherTest, RequiresTheDescribedMarkings) {
  // A bar that joins the upper ends of the strokes makes the H an A.
  pad_.marks = {models::PadMarking{
      .shape = models::PadMarking::Shape::kBar, .center_m = {0.042, 0.0}, .length_m = 0.016, .width_m = 0.03}};
  pad_.Validate();
  EXPECT_TRUE(Find(kDescribed));
  EXPECT_FALSE(Find([](const Artwork& pad, const Vector2d& p) { return pad.outline.IsLetter(p); }));
}

TEST_F(PadTemplateMatcherTest, IgnoresAnUndescribedMarkingBesideTheH) {
  const Black dotted = [](const Artwork& pad, const Vector2d& p) {
    return pad.outline.IsLetter(p) || (p - Vector2d(0.0, 0.045)).norm() < 0.01;
  };
  EXPECT_TRUE(Find(dotted));
}

TEST_F(PadTemplateMatcherTest, RejectsASquareFrame) {
  SetView({});
  const models::PadOutline outline(pad_);
  tests::PadAppearance appearance{.noise_sigma = 0.0};
  appearance.paint = [&](const Vector2d& p) -> std::optional<double> {
    const double side = p.cwiseAbs().maxCoeff();
    if (side > 0.105 || p.norm() < 0.6 * pad_.inner_radius_m()) return std::nullopt;
    return side > 0.07 && side < 0.086 ? 25.0 : outline.IsLetter(p) ? 25.0 : 215.0;
  };
  const models::Image image = tests::RenderPad(camera_, pad_, X_WC_, appearance);
  const Eigen::Isometry3d X_CW = X_WC_.inverse();
  const CirclePose pose{X_CW.linear().col(2), X_CW.translation()};
  const DownsampledCamera camera{camera_, undistort_, 1};
  EXPECT_FALSE(PadTemplateMatcher(pad_).Find(image.View(), PadPlane(pose, camera)));
}

TEST_F(PadTemplateMatcherTest, RejectsInvalidSettings) {
  EXPECT_THROW((TemplateMatcherConfig{.min_bar = 0.0}.Validate()), InputError);
  EXPECT_THROW((TemplateMatcherConfig{.min_between_strokes = 1.1}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::pad
