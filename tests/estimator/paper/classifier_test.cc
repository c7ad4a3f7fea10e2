#include "estimator/paper/classifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "models/angles.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Label = ComponentClass;
using models::PadLetter;

models::Image Blank() { return {160, 120}; }

void FillBox(models::Image& dark, int u, int v, int width, int height) {
  for (int row = v; row < v + height; ++row) std::fill_n(dark.Row(row) + u, width, std::uint8_t{255});
}

/// Pattern of the only component of `dark`.
Pattern PatternOfOnly(const models::Image& dark) {
  const ComponentSet set = ExtractComponents(dark.View());
  EXPECT_EQ(set.components.size(), 1u);
  return PatternOf(set, set.components.front());
}

float At(const Pattern& pattern, int row, int column) {
  return pattern[static_cast<std::size_t>(row * kPatternSide + column)];
}

double Sum(const Pattern& pattern) { return std::accumulate(pattern.begin(), pattern.end(), 0.0); }

TEST(PatternOf, IsOneEverywhereForAFilledBox) {
  for (const auto& [width, height] : {std::pair{14, 14}, {28, 28}, {7, 28}, {28, 7}, {100, 100}, {9, 13}, {61, 17}}) {
    models::Image dark = Blank();
    FillBox(dark, 20, 10, width, height);
    for (const float cell : PatternOfOnly(dark)) EXPECT_NEAR(cell, 1.0F, 1e-5F) << width << " x " << height;
  }
}

TEST(PatternOf, ComputesTheCoveredFractionOfEachCell) {
  // An L of 28 x 28 pixels, the left column and the bottom row. A cell is 2 x 2 pixels.
  models::Image dark = Blank();
  FillBox(dark, 20, 10, 1, 28);
  FillBox(dark, 20, 37, 28, 1);
  const Pattern pattern = PatternOfOnly(dark);
  EXPECT_FLOAT_EQ(At(pattern, 0, 0), 0.5F);
  EXPECT_FLOAT_EQ(At(pattern, 6, 0), 0.5F);
  EXPECT_FLOAT_EQ(At(pattern, 13, 5), 0.5F);
  EXPECT_FLOAT_EQ(At(pattern, 13, 0), 0.75F);
  EXPECT_FLOAT_EQ(At(pattern, 5, 5), 0.0F);
}

TEST(PatternOf, DistributesAPixelOverItsCells) {
  // An L of 7 x 28 pixels. A pixel is two cells wide and half a cell high.
  models::Image dark = Blank();
  FillBox(dark, 20, 10, 1, 28);
  FillBox(dark, 20, 37, 7, 1);
  const Pattern pattern = PatternOfOnly(dark);
  EXPECT_FLOAT_EQ(At(pattern, 0, 0), 1.0F);
  EXPECT_FLOAT_EQ(At(pattern, 0, 1), 1.0F);
  EXPECT_FLOAT_EQ(At(pattern, 0, 2), 0.0F);
  EXPECT_FLOAT_EQ(At(pattern, 13, 7), 0.5F);
}

TEST(PatternOf, ConservesTheDarkArea) {
  for (const auto& [width, height] : {std::pair{9, 13}, {31, 44}, {100, 100}, {150, 15}}) {
    models::Image dark = Blank();
    models::RandomStream random(1, "tests.classifier");
    FillBox(dark, 0, 0, width, 1);
    FillBox(dark, 0, height - 1, width, 1);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        if (random.Bernoulli(0.7)) dark.Row(v)[u] = 255;
      }
    }
    const ComponentSet set = ExtractComponents(dark.View());
    const Component& component = set.components.front();
    ASSERT_EQ(component.width, width);
    ASSERT_EQ(component.height, height);
    const double cell_px = static_cast<double>(width) * height / kPatternSize;
    EXPECT_NEAR(Sum(PatternOf(set, component)) * cell_px, component.area, 1e-3 * component.area);
  }
}

TEST(PatternOf, IgnoresOtherComponentsInTheBox) {
  models::Image alone = Blank();
  FillBox(alone, 20, 10, 60, 60);
  for (int v = 20; v < 60; ++v) std::fill_n(alone.Row(v) + 30, 40, std::uint8_t{0});
  models::Image with_another = alone;
  FillBox(with_another, 40, 30, 20, 20);
  const ComponentSet both = ExtractComponents(with_another.View());
  ASSERT_EQ(both.components.size(), 2u);
  EXPECT_EQ(PatternOf(both, both.components.front()), PatternOfOnly(alone));
}

TEST(Classify, ReturnsNormalizedPosteriorsAndTheLabelOfTheLargest) {
  models::RandomStream random(2, "tests.classifier");
  for (int i = 0; i < 100; ++i) {
    Pattern pattern;
    for (float& cell : pattern) cell = static_cast<float>(random.Uniform());
    const Classification classification = Classify(pattern, i % 2 == 0 ? PadLetter::kH : PadLetter::kRectangle);
    double sum = 0.0;
    for (const double posterior : classification.posterior) {
      EXPECT_GE(posterior, 0.0);
      EXPECT_LE(posterior, classification.posterior[static_cast<std::size_t>(classification.label)]);
      sum += posterior;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

/// Camera with half the resolution of the default camera and the same field of view: at half the distance the pad has
/// the same size in pixels.
const models::CameraModel kCamera{
    .width_px = 320, .height_px = 240, .fx_px = 160.0, .fy_px = 160.0, .cx_px = 159.5, .cy_px = 119.5};

/// View of the pad from `distance_m`, tilted by `tilt_deg`, with the image's up direction rotated by `yaw_deg`.
struct View {
  double distance_m, tilt_deg, yaw_deg;
};

std::vector<View> Views() {
  std::vector<View> views;
  for (const double distance_m : {0.16, 0.35, 0.6, 0.9}) {
    for (const double tilt_deg : {0.0, 25.0}) {
      for (const double yaw_deg : {0.0, 30.0, 75.0, 130.0}) views.push_back({distance_m, tilt_deg, yaw_deg});
    }
  }
  return views;
}

/// Components of an image from a known camera pose.
struct Observation {
  Eigen::Isometry3d X_WC;
  ComponentSet components;

  /// The component near the pad's center with a size of about `size_m`; nullptr if there is none.
  const Component* ComponentOfSize(double size_m) const {
    const Vector3d p_C = X_WC.inverse() * Vector3d::Zero();
    const Vector2d pixel = *kCamera.Project(p_C);
    const double px_per_m = kCamera.fx_px / p_C.z();
    for (const Component& component : components.components) {
      const Vector2d center(component.u + 0.5 * component.width, component.v + 0.5 * component.height);
      const double size_px = std::max(component.width, component.height);
      if ((center - pixel).norm() < 0.25 * size_m * px_per_m && size_px > 0.6 * size_m * px_per_m &&
          size_px < 1.7 * size_m * px_per_m) {
        return &component;
      }
    }
    return nullptr;
  }
};

Observation Observe(const View& view, const tests::PadAppearance& appearance, const models::LandingPad& pad = {}) {
  Observation observation;
  observation.X_WC =
      tests::CameraAbovePad(Vector3d::Zero(), models::DegToRad(view.yaw_deg), models::DegToRad(view.tilt_deg), 0.8);
  observation.X_WC.translation() = -view.distance_m * observation.X_WC.linear().col(2);
  models::RandomStream random(1, "tests.classifier.noise");
  const models::Image image = tests::RenderPad(kCamera, pad, observation.X_WC, appearance, &random);
  observation.components = ExtractComponents(Binarize(image.View()).View());
  return observation;
}

std::string ViewText(const View& view) {
  return std::to_string(view.distance_m) + " m, tilted " + std::to_string(view.tilt_deg) + ", rotated " +
         std::to_string(view.yaw_deg);
}

TEST(Classify, RecognizesRingAndHInAllViews) {
  for (const View& view : Views()) {
    const Observation observation = Observe(view, {.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5});
    const Component* ring = observation.ComponentOfSize(0.18);
    const Component* letter = observation.ComponentOfSize(0.09);
    ASSERT_TRUE(ring != nullptr && letter != nullptr) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *ring, PadLetter::kH).label, Label::kCircle) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *letter, PadLetter::kH).label, Label::kH) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *letter, PadLetter::kRectangle).label, Label::kOther) << ViewText(view);
  }
}

TEST(Classify, RecognizesRingAndRectangleWithTheRectangleNetwork) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  for (const View& view : Views()) {
    if (view.distance_m < 0.2) continue;  // The threshold window fits into the rectangle and makes it hollow.
    const Observation observation = Observe(view, {.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5}, pad);
    const Component* ring = observation.ComponentOfSize(0.18);
    const Component* letter = observation.ComponentOfSize(0.09);
    ASSERT_TRUE(ring != nullptr && letter != nullptr) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *ring, PadLetter::kRectangle).label, Label::kCircle) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *letter, PadLetter::kRectangle).label, Label::kH) << ViewText(view);
    EXPECT_EQ(Classify(observation.components, *letter, PadLetter::kH).label, Label::kOther) << ViewText(view);
  }
}

/// Observation of a dark shape around the origin on white ground. The shape is scaled by 90 mm.
Observation ObserveShape(bool (*is_dark)(const Vector2d& q), const View& view) {
  tests::PadAppearance appearance{.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5};
  appearance.paint = [&](const Vector2d& p) -> std::optional<double> { return is_dark(p / 0.09) ? 25.0 : 215.0; };
  return Observe(view, appearance);
}

std::vector<Label> LabelsOf(const Observation& observation) {
  std::vector<Label> labels;
  for (const Component& component : observation.components.components) {
    labels.push_back(Classify(observation.components, component, PadLetter::kH).label);
  }
  return labels;
}

TEST(Classify, LabelsBarsAndHalfDiscsAsOther) {
  for (const View& view : Views()) {
    for (const auto& is_dark : {+[](const Vector2d& q) { return std::abs(q.x()) < 1.0 && std::abs(q.y()) < 0.25; },
                                +[](const Vector2d& q) { return q.norm() < 1.0 && q.x() > 0.0; }}) {
      EXPECT_THAT(LabelsOf(ObserveShape(is_dark, view)), testing::ElementsAre(Label::kOther)) << ViewText(view);
    }
  }
}

/// At close range the threshold window fits into a disc and turns it into a ring, which only the pad's geometry can
/// reject. The test skips these views.
TEST(Classify, LabelsASolidDiscAsOther) {
  int whole = 0;
  for (const View& view : Views()) {
    const Observation observation = ObserveShape([](const Vector2d& q) { return q.norm() < 1.0; }, view);
    ASSERT_EQ(observation.components.components.size(), 1u) << ViewText(view);
    const Component& disc = observation.components.components.front();
    if (disc.area < 0.95 * models::kPi / 4.0 * disc.width * disc.height) continue;
    EXPECT_THAT(LabelsOf(observation), testing::ElementsAre(Label::kOther)) << ViewText(view);
    ++whole;
  }
  EXPECT_GE(whole, 16);
}

TEST(Classify, RarelyLabelsACheckerboardAsHAndNeverAsRing) {
  const auto is_dark = [](const Vector2d& q) {
    if (q.cwiseAbs().maxCoeff() > 1.3) return false;
    return (static_cast<int>(std::floor(3.0 * q.x())) + static_cast<int>(std::floor(3.0 * q.y()))) % 2 == 0;
  };
  std::vector<Label> labels;
  for (const View& view : Views()) {
    for (const Label label : LabelsOf(ObserveShape(is_dark, view))) labels.push_back(label);
  }
  ASSERT_GT(labels.size(), 100u);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), Label::kCircle), 0);
  EXPECT_LT(std::count(labels.begin(), labels.end(), Label::kH), 0.03 * static_cast<double>(labels.size()));
}

}  // namespace
}  // namespace touchdown::estimator::paper
