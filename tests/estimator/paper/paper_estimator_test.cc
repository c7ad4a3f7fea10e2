#include "estimator/paper/paper_estimator.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "models/angles.h"
#include "tests/support/paper_estimator_fixture.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector3d;
using tests::GravityIn;
using tests::kFrame;
using tests::PadAppearance;

using PaperEstimatorTest = tests::PaperEstimatorFixture;

double AngleBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return models::RotationLog(a.linear().transpose() * b.linear()).norm();
}

TEST_F(PaperEstimatorTest, CallsOnStageForEachStage) {
  std::vector<FrameStage> stages;
  setup_.on_stage = [&stages](FrameStage stage) { stages.push_back(stage); };
  estimator_ = std::make_unique<PaperEstimator>(setup_);
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.0, 0.0, 0.7});
  EstimateView(X_WB);
  EXPECT_EQ(stages, (std::vector{FrameStage::kRecognition, FrameStage::kGeometry}));
  stages.clear();
  EstimateView(X_WB, {.ring = false, .letter = false});
  EXPECT_EQ(stages, std::vector{FrameStage::kRecognition});
}

TEST_F(PaperEstimatorTest, FindsTheBodyAboveThePad) {
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.08, -0.05, 0.7}, 0.2, 0.1, 0.6);
  const FrameResult result = EstimateView(X_WB);
  ASSERT_EQ(result.status, FrameStatus::kOk);
  ASSERT_TRUE(result.pose);
  EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.030);
  EXPECT_NEAR(result.pose->X_WB.translation().z(), X_WB.translation().z(), 0.004);
  EXPECT_LT(AngleBetween(result.pose->X_WB, X_WB), models::DegToRad(3.0));
  EXPECT_EQ(result.mid_exposure, tick_);
}

TEST_F(PaperEstimatorTest, ReturnsAnOverlay) {
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, 0.6});
  const FrameResult result = EstimateView(X_WB);
  const Overlay::Ellipse* const ring_outer = result.overlay.FindEllipse("ring_outer");
  const Overlay::Ellipse* const ring_inner = result.overlay.FindEllipse("ring_inner");
  ASSERT_TRUE(ring_outer && ring_inner && result.overlay.FindEllipse("letter") && result.pad_px);
  const double ratio = ring_inner->semi_axes.x() / ring_outer->semi_axes.x();
  EXPECT_NEAR(ratio, setup_.pad.inner_radius_m() / setup_.pad.outer_radius_m, 0.01);
  const auto center = setup_.camera.Project((X_WB * setup_.X_BC).inverse() * Vector3d::Zero());
  EXPECT_LT((*result.pad_px - *center).norm(), 1.0);
  EXPECT_LT((ring_outer->center - *center).norm(), 2.0);
  int circles = 0, letters = 0;
  for (const Overlay::Box& box : result.overlay.boxes) {
    circles += box.name == "circle";
    letters += box.name == "h";
    EXPECT_GT(box.probability.value(), 1.0 / 3.0);
    EXPECT_LE(box.probability.value(), 1.0);
  }
  EXPECT_GE(circles, 1);
  EXPECT_GE(letters, 1);
}

TEST_F(PaperEstimatorTest, SelectsTheBranchByGravity) {
  for (const double side : {-1.0, 1.0}) {
    const double tilt = side * models::DegToRad(15.0);
    Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), 0.0, tilt, 0.0);
    X_WC.translation() = -X_WC.linear().col(2) * 0.6;
    const Eigen::Isometry3d X_WB = X_WC * setup_.X_BC.inverse();
    const models::Image image = Render(X_WB);
    PaperEstimator estimator(setup_);
    const auto right = estimator.Estimate(image.View(), 0, GravityIn(X_WB));
    ASSERT_TRUE(right.pose);
    EXPECT_LT(AngleBetween(right.pose->X_WB, X_WB), models::DegToRad(2.0));
    // With gravity for the opposite tilt it selects the other hypothesis, which differs by 30 degrees and 0.3 m.
    const Eigen::Isometry3d other = tests::CameraAbovePad({0, 0, 1}, 0.0, -tilt, 0.0) * setup_.X_BC.inverse();
    const auto wrong = estimator.Estimate(image.View(), kFrame, GravityIn(other));
    ASSERT_TRUE(wrong.pose);
    EXPECT_NEAR(models::RadToDeg(AngleBetween(wrong.pose->X_WB, X_WB)), 30.0, 3.0);
    EXPECT_EQ(wrong.status, FrameStatus::kRejected);
  }
}

/// The views are from 0.6 m, tilted to both sides; the two pose hypotheses differ by twice the tilt.
TEST_F(PaperEstimatorTest, SelectsTheBranchByTheArtworkWithoutAnImu) {
  setup_.frame_order = FrameOrder::kUnrelated;
  PaperEstimator estimator(setup_);
  for (const double degrees : {-40.0, -25.0, -15.0, 15.0, 25.0, 40.0}) {
    for (const double direction : {0.0, 1.0, 2.0}) {
      Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), 0.3, models::DegToRad(degrees), direction);
      X_WC.translation() = -X_WC.linear().col(2) * 0.6;
      const Eigen::Isometry3d X_WB = X_WC * setup_.X_BC.inverse();
      const FrameResult result = estimator.Estimate(Render(X_WB).View(), 0, std::nullopt);
      ASSERT_EQ(result.status, FrameStatus::kOk) << degrees;
      // Only the vertical is compared: the yaw is not rectified (Sec. IV-C.3) and has large errors at such tilts.
      const double off = models::AngleBetween(GravityIn(result.pose->X_WB), GravityIn(X_WB));
      EXPECT_LT(off, models::DegToRad(2.0)) << degrees << " " << direction;
      EXPECT_EQ(result.choice->reason, PoseChoice::Reason::kArtwork);
      EXPECT_LT(result.choice->chosen, result.choice->other);
    }
  }
}

TEST_F(PaperEstimatorTest, SelectsTheFrontalPoseWithoutAnImuWhenBothMatchEqually) {
  setup_.frame_order = FrameOrder::kUnrelated;
  PaperEstimator estimator(setup_);
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.0, 0.0, 1.4});
  const FrameResult result = estimator.Estimate(Render(X_WB).View(), 0, std::nullopt);
  ASSERT_EQ(result.status, FrameStatus::kOk);
  EXPECT_EQ(result.choice->reason, PoseChoice::Reason::kFrontal);
  EXPECT_LE(result.choice->chosen, result.choice->other);
}

TEST_F(PaperEstimatorTest, ReportsThePoseChoiceAndTheRingBox) {
  Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), 0.0, 0.3, 0.0);
  X_WC.translation() = -X_WC.linear().col(2) * 0.5;
  const FrameResult result = EstimateView(X_WC * setup_.X_BC.inverse());
  ASSERT_TRUE(result.choice && result.ring_box && result.pad_px);
  EXPECT_EQ(result.choice->reason, PoseChoice::Reason::kGravity);
  EXPECT_LT(result.choice->chosen, models::DegToRad(3.0));
  EXPECT_NEAR(result.choice->other, 0.6, 0.15);
  const double diameter_px = 2.0 * setup_.pad.outer_radius_m / 0.5 * setup_.camera.fx_px;
  EXPECT_NEAR(result.ring_box->width, diameter_px, 0.1 * diameter_px);
  EXPECT_NEAR(result.ring_box->u + 0.5 * result.ring_box->width, result.pad_px->x(), 5.0);
}

TEST_F(PaperEstimatorTest, AcceptsUnrelatedImages) {
  setup_.frame_order = FrameOrder::kUnrelated;
  PaperEstimator estimator(setup_);
  for (const double height : {1.2, 0.4, 1.5, 0.6}) {
    const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.0, 0.1, height});
    EXPECT_EQ(estimator.Estimate(Render(X_WB).View(), 0, GravityIn(X_WB)).status, FrameStatus::kOk) << height;
  }
}

TEST_F(PaperEstimatorTest, SearchesEdgesInFootageWithoutAPadAmongTheComponents) {
  // Glare breaks a stroke of the H and hides a fifth of the ring.
  const auto glare = [](const Eigen::Vector2d& p) -> std::optional<double> {
    const bool on_stroke = (p - Eigen::Vector2d(0.03, 0.02)).norm() < 0.011;
    const bool on_ring = p.norm() < 0.094 && std::abs(std::atan2(p.y(), p.x()) - 0.7) < 0.6 && p.norm() > 0.07;
    return on_stroke || on_ring ? std::optional(230.0) : std::nullopt;
  };
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.05, -0.03, 0.5}, 0.3, 0.2, 0.6);
  const models::Image image = Render(X_WB, {.noise_sigma = 3.0, .paint = glare});
  EXPECT_FALSE(estimator_->Estimate(image.View(), tick_ += kFrame, GravityIn(X_WB)).pose);
  setup_.frame_order = FrameOrder::kUnrelated;
  const FrameResult result = PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB));
  ASSERT_EQ(result.status, FrameStatus::kOk);
  EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.03);
  EXPECT_LT(AngleBetween(result.pose->X_WB, X_WB), models::DegToRad(5.0));
  EXPECT_GT(result.ring_box->width, 100);
}

TEST_F(PaperEstimatorTest, SearchesEdgesInLargeImages) {
  setup_.frame_order = FrameOrder::kUnrelated;
  for (double* length : {&setup_.camera.fx_px, &setup_.camera.fy_px}) *length *= 3.0;
  setup_.camera.width_px = 1920;
  setup_.camera.height_px = 1440;
  setup_.camera.cx_px = 959.5;
  setup_.camera.cy_px = 719.5;
  const auto glare = [](const Eigen::Vector2d& p) -> std::optional<double> {
    return (p - Eigen::Vector2d(0.03, 0.02)).norm() < 0.011 ? std::optional(230.0) : std::nullopt;
  };
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.05, -0.03, 0.5}, 0.3, 0.2, 0.6);
  const models::Image image = Render(X_WB, {.samples_per_side = 2, .paint = glare});
  const FrameResult result = PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB));
  ASSERT_EQ(result.status, FrameStatus::kOk);
  EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.01);
  EXPECT_NEAR(result.ring_box->u + 0.5 * result.ring_box->width, result.pad_px->x(), 15.0);
}

TEST_F(PaperEstimatorTest, AcceptsImagesOfAnySize) {
  setup_.frame_order = FrameOrder::kUnrelated;
  for (const auto& [width, height] : {std::pair(2000, 2), {2, 2000}, {1, 1}, {3, 3}}) {
    setup_.camera.width_px = width;
    setup_.camera.height_px = height;
    const models::Image image(width, height);
    EXPECT_EQ(PaperEstimator(setup_).Estimate(image.View(), 0, std::nullopt).reason, "no_component");
  }
}

TEST_F(PaperEstimatorTest, HasAConsistentYawVarianceForASquareH) {
  setup_.pad.h_height_m = setup_.pad.h_width_m = 0.08;
  for (const FrameOrder order : {FrameOrder::kFlight, FrameOrder::kUnrelated}) {
    setup_.frame_order = order;
    for (const double direction : {0.0, 0.8, 1.6}) {
      Eigen::Isometry3d X_WC = tests::CameraAbovePad(Vector3d::Zero(), 0.0, models::DegToRad(30.0), direction);
      X_WC.translation() = -X_WC.linear().col(2) * 0.3;
      const Eigen::Isometry3d X_WB = X_WC * setup_.X_BC.inverse();
      const auto result = PaperEstimator(setup_).Estimate(Render(X_WB).View(), 0, GravityIn(X_WB));
      if (order == FrameOrder::kFlight && !result.pose) continue;  // The classifier is not trained for a square H.
      ASSERT_TRUE(result.pose) << direction;
      const double error = models::TaitBryanFromRotation(result.pose->X_WB.linear()).yaw -
                           models::TaitBryanFromRotation(X_WB.linear()).yaw;
      EXPECT_LT(std::abs(error), 3.0 * std::sqrt(result.pose->covariance(5, 5))) << direction;
    }
  }
}

TEST_F(PaperEstimatorTest, MeasuresTheYawOfASquareH) {
  setup_.frame_order = FrameOrder::kUnrelated;
  setup_.pad.h_height_m = setup_.pad.h_width_m = 0.08;
  PaperEstimator estimator(setup_);
  for (int deg = -85; deg <= 85; deg += 34) {
    const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, 0.5}, models::DegToRad(deg));
    const auto result = estimator.Estimate(Render(X_WB).View(), 0, GravityIn(X_WB));
    ASSERT_TRUE(result.pose) << deg;
    EXPECT_NEAR(models::RadToDeg(models::TaitBryanFromRotation(result.pose->X_WB.linear()).yaw), deg, 1.5);
  }
}

TEST_F(PaperEstimatorTest, MeasuresYawWithin90Degrees) {
  for (int deg = -85; deg <= 85; deg += 34) {
    const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, 0.5}, models::DegToRad(deg));
    const auto result = EstimateView(X_WB);
    ASSERT_TRUE(result.pose) << deg;
    EXPECT_NEAR(models::RadToDeg(models::TaitBryanFromRotation(result.pose->X_WB.linear()).yaw), deg, 1.5);
    EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.02);
  }
}

models::LandingPad PadWithRectangle() {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  return pad;
}

TEST_F(PaperEstimatorTest, FindsTheBodyAboveAPadWithARectangle) {
  setup_.pad = PadWithRectangle();
  for (const FrameOrder order : {FrameOrder::kFlight, FrameOrder::kUnrelated}) {
    setup_.frame_order = order;
    for (const double height : {0.25, 0.6, 1.4}) {
      for (const int deg : {-85, -17, 51}) {
        const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.01, height}, models::DegToRad(deg), 0.05, 0.6);
        const models::Image image = Render(X_WB, {.noise_sigma = 3.0, .samples_per_side = 3});
        const auto result = PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB));
        ASSERT_TRUE(result.pose) << height << " " << deg << " " << Name(result.status);
        EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.04 * height);
        EXPECT_LT(AngleBetween(result.pose->X_WB, X_WB), models::DegToRad(2.5)) << height << " " << deg;
      }
    }
  }
}

TEST_F(PaperEstimatorTest, RejectsAPadWithAnotherLetter) {
  const models::LandingPad with_h, with_rectangle = PadWithRectangle();
  for (const FrameOrder order : {FrameOrder::kFlight, FrameOrder::kUnrelated}) {
    setup_.frame_order = order;
    for (const auto& [printed, described] : {std::pair(with_h, with_rectangle), {with_rectangle, with_h}}) {
      for (const double height : {0.4, 1.0}) {
        const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.05, -0.02, height}, 0.4, 0.1, 0.6);
        setup_.pad = printed;
        const models::Image image = Render(X_WB, {.noise_sigma = 3.0, .samples_per_side = 3});
        ASSERT_TRUE(PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB)).pose) << height;
        setup_.pad = described;
        EXPECT_FALSE(PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB)).pose) << height;
      }
    }
  }
}

TEST_F(PaperEstimatorTest, VerifiesWithTheTemplateUnlessDisabled) {
  // The classifier of the test labels another letter as the described H.
  const ComponentClassifier classify = [](const ComponentSet&, const Component& component) {
    Classification classification;
    classification.label = component.width > 60 ? ComponentClass::kCircle : ComponentClass::kH;
    classification.posterior[static_cast<std::size_t>(classification.label)] = 1.0;
    return classification;
  };
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, -0.01, 0.6}, 0.4);
  EstimatorSetup other_letter = setup_;
  other_letter.pad = PadWithRectangle();
  const models::Image image =
      tests::RenderPad(setup_.camera, other_letter.pad, X_WB * setup_.X_BC, {.noise_sigma = 3.0}, &random_);
  PaperEstimatorConfig config;
  EXPECT_EQ(PaperEstimator(setup_, config, classify).Estimate(image.View(), 0, GravityIn(X_WB)).reason, "no_ellipse");
  config.search.verify = Verify::kNone;
  const FrameResult result = PaperEstimator(setup_, config, classify).Estimate(image.View(), 0, GravityIn(X_WB));
  ASSERT_EQ(result.status, FrameStatus::kOk) << result.reason;
  EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.02);
}

TEST_F(PaperEstimatorTest, FindsThePadWithoutTheTemplate) {
  PaperEstimatorConfig config;
  config.search.verify = Verify::kNone;
  for (const double height : {0.3, 0.6, 1.0, 1.5}) {
    const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, -0.01, height}, 0.4, 0.1, 0.7);
    const models::Image image = Render(X_WB);
    const FrameResult published = PaperEstimator(setup_, config).Estimate(image.View(), 0, GravityIn(X_WB));
    const FrameResult verified = PaperEstimator(setup_).Estimate(image.View(), 0, GravityIn(X_WB));
    ASSERT_TRUE(published.pose && verified.pose) << height;
    EXPECT_TRUE(published.pose->X_WB.isApprox(verified.pose->X_WB)) << height;
  }
}

TEST_F(PaperEstimatorTest, FindsThePadAmongClutter) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto clutter = tests::Clutter(setup_.pad, seed);
    const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.1, 0.05, 0.9}, 0.1);
    PaperEstimator estimator(setup_);
    FrameResult result;
    const models::Image image = Render(X_WB, {.noise_sigma = 3.0, .paint = clutter});
    for (models::Tick tick = 0; tick < 3 * kFrame; tick += kFrame) {
      result = estimator.Estimate(image.View(), tick, GravityIn(X_WB));
    }
    ASSERT_EQ(result.status, FrameStatus::kOk) << seed;
    EXPECT_GT(result.overlay.boxes.size(), 5u);
    EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.05);
  }
}

TEST_F(PaperEstimatorTest, IsDeterministic) {
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.05, 0.02, 0.8}, 0.1, 0.05);
  const models::Image image = Render(X_WB);
  PaperEstimator first(setup_), second(setup_);
  const auto a = first.Estimate(image.View(), 0, GravityIn(X_WB)),
             b = second.Estimate(image.View(), 0, GravityIn(X_WB));
  ASSERT_TRUE(a.pose && b.pose);
  EXPECT_EQ(a.pose->X_WB.matrix(), b.pose->X_WB.matrix());
  EXPECT_EQ(a.pose->covariance, b.pose->covariance);
}

TEST_F(PaperEstimatorTest, UsesTheStride) {
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.05, 0.02, 0.6});
  const models::Image image = Render(X_WB);
  std::vector<std::uint8_t> padded(700 * 480, 17);
  for (int v = 0; v < 480; ++v) std::copy_n(image.View().Row(v), 640, padded.begin() + v * 700);
  PaperEstimator first(setup_), second(setup_);
  const auto a = first.Estimate(image.View(), 0, GravityIn(X_WB));
  const auto b = second.Estimate({padded.data(), 640, 480, 700}, 0, GravityIn(X_WB));
  ASSERT_TRUE(a.pose && b.pose);
  EXPECT_EQ(a.pose->X_WB.matrix(), b.pose->X_WB.matrix());
}

TEST_F(PaperEstimatorTest, RejectsAnImageOfWrongSizeOrStride) {
  const models::Image image(320, 240, 100);
  EXPECT_THROW(EstimateImage(image, Eigen::Isometry3d::Identity()), std::invalid_argument);
  EXPECT_THROW(estimator_->Estimate({}, 0, -Vector3d::UnitZ()), std::invalid_argument);
  const models::Image whole(640, 480, 200);
  for (const std::ptrdiff_t stride : {0, 639, -640}) {
    models::ImageView view = whole.View();
    view.stride = stride;
    EXPECT_THROW(estimator_->Estimate(view, 0, -Vector3d::UnitZ()), std::invalid_argument) << stride;
  }
}

TEST_F(PaperEstimatorTest, ReportsAPositiveDefiniteCovarianceThatGrowsWithHeight) {
  const auto near = EstimateView(BodyWithCameraAt({0.02, 0.0, 0.4}, 0.0, 0.05));
  ASSERT_TRUE(near.pose) << Name(near.status);
  PaperEstimator estimator(setup_);
  const Eigen::Isometry3d X_WB = BodyWithCameraAt({0.02, 0.0, 1.6}, 0.0, 0.05);
  const auto far = estimator.Estimate(Render(X_WB).View(), 0, GravityIn(X_WB));
  ASSERT_TRUE(far.pose) << Name(far.status);
  for (const auto* frame : {&near, &far}) {
    EXPECT_EQ(frame->pose->covariance.llt().info(), Eigen::Success);
  }
  EXPECT_GT(far.pose->covariance.topLeftCorner(3, 3).trace(), 4.0 * near.pose->covariance.topLeftCorner(3, 3).trace());
}

}  // namespace
}  // namespace touchdown::estimator::paper
