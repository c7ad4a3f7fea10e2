#include "estimator/paper/pad_detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Label = ComponentClass;

Component Box(int u, int v, int width, int height) { return {u, v, width, height, width * height, 0, 0}; }

/// Classifier that returns the label and posterior for the left side of a component's box.
ComponentClassifier ClassifierFor(const std::map<int, std::pair<Label, double>>& labels) {
  return [labels](const ComponentSet&, const Component& component) {
    const auto& [label, posterior] = labels.at(component.u);
    Classification classification;
    classification.label = label;
    classification.posterior.fill((1.0 - posterior) / 2.0);
    classification.posterior[static_cast<std::size_t>(label)] = posterior;
    return classification;
  };
}

ComponentSet SetOf(std::vector<Component> components) {
  ComponentSet set{.image_width = 640, .image_height = 480, .runs = {}, .components = {}};
  set.components = std::move(components);
  return set;
}

const ComponentClassifier kUnused = [](const ComponentSet&, const Component&) { return Classification(); };

TEST(PadDetector, ReturnsTheFirstStepThatFailed) {
  const models::LandingPad pad;
  const Component ring = Box(100, 100, 90, 90), letter = Box(131, 120, 28, 50), far_letter = Box(300, 120, 28, 50);
  const std::map<int, std::pair<Label, double>> labels{
      {100, {Label::kCircle, 0.9}}, {131, {Label::kH, 0.9}}, {300, {Label::kH, 0.99}}, {7, {Label::kOther, 0.9}}};
  const PadDetector detector(pad, ClassifierFor(labels));
  const auto status = [&](std::vector<Component> components) {
    return std::get<Reason>(detector.Detect(SetOf(std::move(components))).outcome);
  };
  EXPECT_EQ(status({}), Reason::kNoComponent);
  EXPECT_EQ(status({Box(7, 7, 20, 20)}), Reason::kNoCircle);
  EXPECT_EQ(status({letter}), Reason::kNoCircle);
  EXPECT_EQ(status({ring, Box(7, 7, 20, 20)}), Reason::kNoH);
  EXPECT_EQ(status({ring, far_letter}), Reason::kNoPair);

  const auto found = detector.Detect(SetOf({ring, far_letter, letter}));
  ASSERT_TRUE(std::holds_alternative<std::vector<DetectedPad>>(found.outcome));
  const auto& candidates = std::get<std::vector<DetectedPad>>(found.outcome);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_EQ(candidates[0].ring.u, 100);
  EXPECT_EQ(candidates[0].letter.u, 131);
}

TEST(PadDetector, IgnoresARingCutByTheImageBorder) {
  const Component letter = Box(131, 120, 28, 50);
  const std::map<int, std::pair<Label, double>> labels{
      {0, {Label::kCircle, 0.9}}, {100, {Label::kCircle, 0.9}}, {550, {Label::kCircle, 0.9}}, {131, {Label::kH, 0.9}}};
  const PadDetector detector(models::LandingPad(), ClassifierFor(labels));
  for (const Component& cut :
       {Box(0, 100, 90, 90), Box(100, 0, 90, 90), Box(550, 100, 90, 90), Box(100, 390, 90, 90)}) {
    EXPECT_EQ(std::get<Reason>(detector.Detect(SetOf({cut, letter})).outcome), Reason::kNoCircle);
  }
}

TEST(PadDetector, ReturnsEveryComponentWithLabelAndPosterior) {
  const PadDetector detector(models::LandingPad(), ClassifierFor({{1, {Label::kOther, 0.8}}, {50, {Label::kH, 0.7}}}));
  const auto result = detector.Detect(SetOf({Box(1, 2, 30, 40), Box(50, 60, 28, 50)}));
  ASSERT_EQ(result.labeled.size(), 2u);
  EXPECT_EQ(result.labeled[0].label, Label::kOther);
  EXPECT_EQ(result.labeled[0].box.height, 40);
  EXPECT_EQ(result.labeled[1].label, Label::kH);
  EXPECT_DOUBLE_EQ(result.labeled[1].probability, 0.7);
}

TEST(PadDetector, SortsPairsByPosterior) {
  const PadDetector detector(models::LandingPad(), ClassifierFor({{100, {Label::kCircle, 0.9}},
                                                                  {130, {Label::kH, 0.6}},
                                                                  {300, {Label::kCircle, 0.8}},
                                                                  {330, {Label::kH, 0.9}}}));
  const auto result = detector.Detect(
      SetOf({Box(100, 100, 90, 90), Box(130, 120, 28, 50), Box(300, 100, 90, 90), Box(330, 120, 28, 50)}));
  const auto& candidates = std::get<std::vector<DetectedPad>>(result.outcome);
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].ring.u, 300);
  EXPECT_EQ(candidates[1].ring.u, 100);
}

TEST(PadDetector, ComparesSizeAndCenterOfLetterAndRing) {
  const PadDetector detector(models::LandingPad(), kUnused);
  const Component ring = Box(100, 100, 90, 90);
  EXPECT_TRUE(detector.IsPossiblePad(ring, Box(131, 120, 28, 50)));
  EXPECT_TRUE(detector.IsPossiblePad(ring, Box(120, 131, 50, 28)));   // Rotated by 90 degrees.
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(91, 120, 28, 50)));   // Partly outside the ring.
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(105, 120, 28, 50)));  // Off the center.
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(131, 102, 28, 50)));
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(141, 140, 8, 10)));   // Too small.
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(105, 105, 80, 80)));  // Too large.
  EXPECT_FALSE(detector.IsPossiblePad(ring, Box(140, 100, 10, 90)));  // A bar through the ring.
  EXPECT_FALSE(detector.IsPossiblePad(Box(131, 120, 28, 50), ring));
}

/// Bounding box of the projections of `points` of the pad's plane.
Component BoxOf(const models::CameraModel& camera, const Eigen::Isometry3d& X_CW,
                const std::vector<Eigen::Vector2d>& points) {
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector2d& p : points) {
    const auto pixel = camera.Project(X_CW * Eigen::Vector3d(p.x(), p.y(), 0.0));
    if (!pixel) return Box(-1000, -1000, 1, 1);
    low = low.min(pixel->array());
    high = high.max(pixel->array());
  }
  const int u = static_cast<int>(std::lround(low.x())), v = static_cast<int>(std::lround(low.y()));
  return Box(u, v, static_cast<int>(std::lround(high.x())) - u + 1, static_cast<int>(std::lround(high.y())) - v + 1);
}

TEST(PadDetector, AcceptsThePadAtAnyHeightYawAndTiltUpTo50Degrees) {
  const models::CameraModel camera;
  const models::LandingPad pad;
  const PadDetector detector(pad, kUnused);
  std::vector<Eigen::Vector2d> circle, corners;
  for (int i = 0; i < 360; ++i) {
    const double angle = models::DegToRad(i);
    circle.emplace_back(pad.outer_radius_m * std::cos(angle), pad.outer_radius_m * std::sin(angle));
  }
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) corners.emplace_back(x * pad.h_height_m, y * pad.h_width_m);
  }
  models::RandomStream random(1, "tests.pad_detector");
  int views = 0;
  for (int i = 0; i < 3000; ++i) {
    Eigen::Isometry3d X_WC =
        tests::CameraAbovePad(Eigen::Vector3d::Zero(), random.Uniform(-3.1, 3.1),
                              models::DegToRad(random.Uniform(0.0, 50.0)), random.Uniform(-3.1, 3.1));
    const Eigen::Vector2d pixel(random.Uniform(150.0, 490.0), random.Uniform(120.0, 360.0));
    X_WC.translation() = -(X_WC.linear() * *camera.Ray(pixel)) * random.Uniform(0.25, 3.0);
    const Component ring = BoxOf(camera, X_WC.inverse(), circle), letter = BoxOf(camera, X_WC.inverse(), corners);
    if (ring.u < 0 || ring.v < 0 || ring.u + ring.width > 640 || ring.v + ring.height > 480) continue;
    if (X_WC.translation().z() < 0.15) continue;
    ++views;
    EXPECT_TRUE(detector.IsPossiblePad(ring, letter)) << X_WC.matrix();
  }
  EXPECT_GT(views, 1500);
}

TEST(PadDetector, RejectsInvalidSettings) {
  EXPECT_THROW((PadDetectorConfig{.size_tolerance = 0.9}.Validate()), InputError);
  EXPECT_THROW((PadDetectorConfig{.center_tolerance = -0.1}.Validate()), InputError);
  EXPECT_THROW((PadDetectorConfig{.max_candidates = 0}.Validate()), InputError);
  models::LandingPad pad;
  pad.outer_radius_m = 0.0;
  EXPECT_THROW(PadDetector(pad, kUnused), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::paper
