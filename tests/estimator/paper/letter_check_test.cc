#include "estimator/paper/letter_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "estimator/paper/binarize.h"
#include "models/angles.h"
#include "models/error.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator {
namespace {

using Eigen::Vector2d;

using Black = std::function<bool(const models::LandingPad&, const Vector2d&)>;

bool OnStroke(const models::LandingPad& pad, const Vector2d& p) {
  const Vector2d q = p.cwiseAbs();
  return q.x() < pad.h_height_m / 2 && q.y() < pad.h_width_m / 2 && q.y() > pad.h_width_m / 2 - pad.h_stroke_m;
}

class LetterCheckTest : public testing::Test {
 protected:
  /// How a letter, alone on white, fits the H from a camera `distance` away and tilted.
  LetterCheck::Fit FitOf(const Black& black, double distance, double tilt_deg) {
    Eigen::Isometry3d X_WC = tests::CameraAbovePad(Eigen::Vector3d::Zero(), 0.4, models::DegToRad(tilt_deg), 1.0);
    X_WC.translation() = -distance * X_WC.linear().col(2);
    tests::PadPicture picture{.floor = 215.0, .ring = false, .letter = false};
    picture.paint = [&](const Vector2d& p) { return black(pad_, p) ? std::optional(25.0) : std::nullopt; };
    const models::Image image = tests::RenderPad(camera_, pad_, X_WC, picture);
    const models::Image dark = Binarize(image.View());
    const ComponentSet components = ExtractComponents(dark.View());
    EXPECT_EQ(components.components.size(), 1u);
    const Eigen::Isometry3d X_CW = X_WC.inverse();
    return LetterCheck(pad_).FitOn({X_CW.linear().col(2), X_CW.translation()}, components, components.components.at(0),
                                   {camera_, undistort_, 1});
  }

  models::CameraModel camera_;
  models::LandingPad pad_;
  UndistortTable undistort_{camera_};
};

const Black kH = [](const models::LandingPad& pad, const Vector2d& p) {
  return p.norm() < pad.inner_radius_m() && pad.IsBlack(p);
};

TEST_F(LetterCheckTest, KnowsTheHFromAnyDistanceAndTilt) {
  for (const double tilt_deg : {0.0, 30.0, 55.0}) {
    const LetterCheck::Fit fit = FitOf(kH, 0.4, tilt_deg);
    EXPECT_GT(fit.resemblance, 0.95) << tilt_deg;
    EXPECT_GT(fit.symmetry, 0.95) << tilt_deg;
    EXPECT_LT(fit.size_error, 1.03) << tilt_deg;
  }
  EXPECT_GT(FitOf(kH, 1.5, 0.0).resemblance, 0.85);
}

TEST_F(LetterCheckTest, TellsOtherLettersFromTheH) {
  const LetterCheckConfig config;
  const Black letter_n = [](const models::LandingPad& pad, const Vector2d& p) {
    const double half_x = pad.h_height_m / 2, half_y = pad.h_width_m / 2 - pad.h_stroke_m / 2;
    const bool diagonal = std::abs(p.x()) < half_x && std::abs(p.y() - p.x() / half_x * half_y) < pad.h_stroke_m / 2;
    return OnStroke(pad, p) || diagonal;
  };
  const Black letter_u = [](const models::LandingPad& pad, const Vector2d& p) {
    const bool base = p.x() > -pad.h_height_m / 2 && p.x() < -pad.h_height_m / 2 + pad.h_stroke_m;
    return OnStroke(pad, p) || (base && std::abs(p.y()) < pad.h_width_m / 2);
  };
  const Black cross = [](const models::LandingPad& pad, const Vector2d& p) {
    const Vector2d q = p.cwiseAbs();
    return q.minCoeff() < pad.h_stroke_m / 2 && q.maxCoeff() < pad.h_height_m / 2;
  };
  for (const Black& letter : {letter_n, letter_u, cross}) {
    const LetterCheck::Fit fit = FitOf(letter, 0.5, 20.0);
    EXPECT_TRUE(fit.resemblance < config.least_resemblance || fit.symmetry < config.least_symmetry);
  }
}

TEST_F(LetterCheckTest, SeesThatAnNIsNotItsOwnMirrorImage) {
  const Black broad_n = [](const models::LandingPad& pad, const Vector2d& p) {
    const double half_y = pad.h_width_m / 2 - pad.h_stroke_m / 2;
    const bool inside = p.cwiseAbs().x() < pad.h_height_m / 2;
    return OnStroke(pad, p) || (inside && std::abs(p.y() - 2 * p.x() / pad.h_height_m * half_y) < pad.h_stroke_m);
  };
  EXPECT_LT(FitOf(broad_n, 0.5, 20.0).symmetry, LetterCheckConfig().least_symmetry);
}

TEST_F(LetterCheckTest, MeasuresHowFarTheSizeIsOff) {
  const Black large = [](const models::LandingPad& pad, const Vector2d& p) { return kH(pad, p / 1.4); };
  const LetterCheck::Fit fit = FitOf(large, 0.5, 20.0);
  EXPECT_NEAR(fit.size_error, 1.4, 0.03);
  EXPECT_GT(fit.resemblance, 0.95);
}

TEST_F(LetterCheckTest, RefusesImpossibleSettings) {
  EXPECT_THROW((LetterCheckConfig{.least_resemblance = 1.0}.Validate()), InputError);
  EXPECT_THROW((LetterCheckConfig{.least_symmetry = 0.0}.Validate()), InputError);
  EXPECT_THROW((LetterCheckConfig{.largest_size_error = 0.9}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator
