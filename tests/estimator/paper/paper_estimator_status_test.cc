// Reasons that the estimator reports for frames without a usable pose.
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

TEST_F(PaperEstimatorStatus, ReportsNoComponentForABlankImage) {
  const models::Image blank(640, 480, 128);
  const FrameResult result = EstimateImage(blank, BodyWithCameraAt({0, 0, 1}));
  EXPECT_EQ(result.reason, "no_component");
  EXPECT_FALSE(result.pose);
  EXPECT_FALSE(result.pad_px);
}

TEST_F(PaperEstimatorStatus, ReportsNoCircleForALetterAlone) {
  const FrameResult result = EstimateView(BodyWithCameraAt({0, 0, 0.6}), {.ring = false});
  EXPECT_EQ(result.reason, "no_circle");
  EXPECT_FALSE(result.overlay.boxes.empty());
}

TEST_F(PaperEstimatorStatus, ReportsNoHForARingAlone) {
  EXPECT_EQ(EstimateView(BodyWithCameraAt({0, 0, 0.6}), {.letter = false}).reason, "no_h");
}

TEST_F(PaperEstimatorStatus, ReportsNoPairForAnHBesideTheRing) {
  const auto letter_aside = [outline = models::PadOutline({})](const Eigen::Vector2d& p) -> std::optional<double> {
    const Eigen::Vector2d q = p - Eigen::Vector2d(0.0, 0.35);
    if (q.norm() > 0.10) return std::nullopt;
    return outline.IsLetter(q) ? 25.0 : 215.0;
  };
  const FrameResult result = EstimateView(BodyWithCameraAt({0, 0.15, 0.6}), {.letter = false, .paint = letter_aside});
  EXPECT_EQ(result.reason, "no_pair");
}

/// A hand that covers the part of the pad with x above `x_m`.
std::function<std::optional<double>(const Eigen::Vector2d&)> HandBeyond(double x_m) {
  return [x_m](const Eigen::Vector2d& p) { return p.x() > x_m ? std::optional(160.0) : std::nullopt; };
}

TEST_F(PaperEstimatorStatus, ReportsNoWrongPoseWhenAHandCoversPartOfTheRing) {
  EstimatorSetup unrelated = setup_;
  unrelated.frame_order = FrameOrder::kUnrelated;
  PaperEstimator footage(unrelated);
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, 0.6});
  for (const double x_m : {-0.03, 0.0, 0.03, 0.055, 0.06, 0.065, 0.07, 0.075, 0.08, 0.085, 0.095}) {
    const FrameResult in_flight = EstimateView(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(x_m)});
    const models::Image image = Render(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(x_m)});
    const FrameResult in_footage = footage.Estimate(image.View(), 0, GravityIn(X_WB));
    for (const FrameResult& result : {in_flight, in_footage}) {
      if (x_m < 0.03) {
        EXPECT_FALSE(result.pose) << "a pose although the hand covers half of the H, x_m = " << x_m;
      }
      if (!result.pose) continue;
      const Eigen::Vector3d error = result.pose->X_WB.translation() - X_WB.translation();
      const Eigen::Vector3d sigma = result.pose->covariance.diagonal().head<3>().cwiseSqrt();
      EXPECT_LT(error.norm(), 0.03) << x_m;
      EXPECT_TRUE((error.array().abs() < 4.0 * sigma.array()).all()) << x_m << ": " << error.transpose();
    }
  }
  EXPECT_EQ(EstimateView(X_WB, {.noise_sigma = 3.0, .paint = HandBeyond(0.095)}).status, FrameStatus::kOk);
}

TEST_F(PaperEstimatorStatus, ReportsNoEllipseForASquareOutline) {
  // A square frame with an H in it. The classifier of the test labels the frame a circle.
  const auto square = [](const Eigen::Vector2d& p) -> std::optional<double> {
    const double side = p.cwiseAbs().maxCoeff();
    if (side > 0.074 && side < 0.09) return 25.0;
    return std::nullopt;
  };
  PaperEstimator estimator(setup_, {}, [](const ComponentSet&, const Component& component) {
    Classification classification;
    classification.label = component.width > 70 ? ComponentClass::kCircle : ComponentClass::kH;
    classification.posterior[static_cast<std::size_t>(classification.label)] = 1.0;
    return classification;
  });
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0, 0, 0.6});
  const models::Image image = Render(X_WB, {.floor = 215.0, .ring = false, .paint = square});
  const FrameResult result = estimator.Estimate(image.View(), 0, GravityIn(X_WB));
  EXPECT_EQ(result.reason, "no_ellipse");
  EXPECT_FALSE(result.pose);
  EXPECT_FALSE(result.pad_px);
}

TEST_F(PaperEstimatorStatus, RejectsAJumpAndReportsItsPose) {
  ASSERT_EQ(EstimateView(BodyWithCameraAt({0, 0, 0.6})).status, FrameStatus::kOk);
  const FrameResult jumped = EstimateView(BodyWithCameraAt({0.3, 0.2, 1.1}));
  EXPECT_EQ(jumped.status, FrameStatus::kRejected);
  ASSERT_TRUE(jumped.pose);
  EXPECT_NEAR(jumped.pose->X_WB.translation().x(), 0.3, 0.1);
  EXPECT_EQ(EstimateView(BodyWithCameraAt({0, 0, 0.61})).status, FrameStatus::kOk);
}

}  // namespace
}  // namespace touchdown::estimator::paper
