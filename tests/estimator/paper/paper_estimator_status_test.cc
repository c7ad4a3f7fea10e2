// At which stage the estimator says that it failed, or that what it found must not be used.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "estimator/paper/paper_estimator.h"
#include "models/pad_outline.h"
#include "tests/support/paper_estimator_fixture.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using tests::GravityIn;

using PaperEstimatorStatus = tests::PaperEstimatorFixture;

TEST_F(PaperEstimatorStatus, SeesABlankImageAsNoComponent) {
  const models::Image blank(640, 480, 128);
  const FrameResult seen = SeeImage(blank, BodyWithCameraAt({0, 0, 1}));
  EXPECT_EQ(seen.reason, "no_component");
  EXPECT_FALSE(seen.pose);
  EXPECT_FALSE(seen.pad_px);
}

TEST_F(PaperEstimatorStatus, SeesALoneLetterAsNoCircle) {
  const FrameResult seen = See(BodyWithCameraAt({0, 0, 0.6}), {.ring = false});
  EXPECT_EQ(seen.reason, "no_circle");
  EXPECT_FALSE(seen.overlay.boxes.empty());
}

TEST_F(PaperEstimatorStatus, SeesALoneRingAsNoH) {
  EXPECT_EQ(See(BodyWithCameraAt({0, 0, 0.6}), {.letter = false}).reason, "no_h");
}

TEST_F(PaperEstimatorStatus, SeesAnHBesideTheRingAsNoPair) {
  const auto letter_aside = [outline = models::PadOutline({})](const Eigen::Vector2d& p) -> std::optional<double> {
    const Eigen::Vector2d q = p - Eigen::Vector2d(0.0, 0.35);
    if (q.norm() > 0.10) return std::nullopt;
    return outline.IsLetter(q) ? 25.0 : 215.0;
  };
  const FrameResult seen = See(BodyWithCameraAt({0, 0.15, 0.6}), {.letter = false, .paint = letter_aside});
  EXPECT_EQ(seen.reason, "no_pair");
}

/// A hand held over the part of the pad beyond `x_m`.
std::function<std::optional<double>(const Eigen::Vector2d&)> HandBeyond(double x_m) {
  return [x_m](const Eigen::Vector2d& p) { return p.x() > x_m ? std::optional(160.0) : std::nullopt; };
}

TEST_F(PaperEstimatorStatus, GivesNoPoseOrTheRightOneWhereAHandCoversPartOfTheRing) {
  EstimatorSetup unrelated = setup_;
  unrelated.frame_order = FrameOrder::kUnrelated;
  PaperEstimator footage(unrelated);
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, 0.6});
  for (const double x_m : {-0.03, 0.0, 0.03, 0.055, 0.06, 0.065, 0.07, 0.075, 0.08, 0.085, 0.095}) {
    const FrameResult in_flight = See(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(x_m)});
    const models::Image image = Picture(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(x_m)});
    const FrameResult in_footage = footage.Estimate(image.View(), 0, GravityIn(X_WB));
    for (const FrameResult& seen : {in_flight, in_footage}) {
      if (x_m < 0.03) {
        EXPECT_FALSE(seen.pose) << "it covers half of the H, beyond " << x_m;
      }
      if (!seen.pose) continue;
      const Eigen::Vector3d error = seen.pose->X_WB.translation() - X_WB.translation();
      const Eigen::Vector3d sigma = seen.pose->covariance.diagonal().head<3>().cwiseSqrt();
      EXPECT_LT(error.norm(), 0.03) << x_m;
      EXPECT_TRUE((error.array().abs() < 4.0 * sigma.array()).all()) << x_m << ": " << error.transpose();
    }
  }
  EXPECT_EQ(See(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(0.095)}).status, FrameStatus::kOk);
}

TEST_F(PaperEstimatorStatus, FindsNoEllipseWhereTheOutlineIsNone) {
  // A square frame with an H in it, that the truth here calls a circle.
  const auto square = [](const Eigen::Vector2d& p) -> std::optional<double> {
    const double side = p.cwiseAbs().maxCoeff();
    if (side > 0.074 && side < 0.09) return 25.0;
    return std::nullopt;
  };
  PaperEstimator estimator(setup_, {}, [](const ComponentSet&, const Component& component) {
    Classification seen;
    seen.label = component.width > 70 ? ComponentClass::kCircle : ComponentClass::kH;
    seen.posterior[static_cast<std::size_t>(seen.label)] = 1.0;
    return seen;
  });
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0, 0, 0.6});
  const models::Image image = Picture(X_WB, {.floor = 215.0, .ring = false, .paint = square});
  const FrameResult seen = estimator.Estimate(image.View(), 0, GravityIn(X_WB));
  EXPECT_EQ(seen.reason, "no_ellipse");
  EXPECT_FALSE(seen.pose);
  EXPECT_FALSE(seen.pad_px);
}

TEST_F(PaperEstimatorStatus, CallsAJumpAnOutlierAndTellsItsPose) {
  ASSERT_EQ(See(BodyWithCameraAt({0, 0, 0.6})).status, FrameStatus::kOk);
  const FrameResult jumped = See(BodyWithCameraAt({0.3, 0.2, 1.1}));
  EXPECT_EQ(jumped.status, FrameStatus::kRejected);
  ASSERT_TRUE(jumped.pose);
  EXPECT_NEAR(jumped.pose->X_WB.translation().x(), 0.3, 0.1);
  EXPECT_EQ(See(BodyWithCameraAt({0, 0, 0.61})).status, FrameStatus::kOk);
}

}  // namespace
}  // namespace touchdown::estimator::paper
