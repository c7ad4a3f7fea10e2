#include "sim/scene/artwork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "models/angles.h"
#include "models/pad_outline.h"
#include "sim/scene/floor_pattern.h"

namespace touchdown::sim {
namespace {

/// Black area of the pad's artwork, m^2, from the mean of its levels.
double InkedArea(const cv::Mat1b& artwork, const models::LandingPad& pad) {
  const double coverage = (kPaper - cv::mean(artwork)[0]) / (kPaper - kInk);
  return coverage * pad.sheet_length_m * pad.sheet_width_m;
}

TEST(PaintPad, InksTheAreaOfTheRingAndTheLetter) {
  const models::LandingPad pad;
  const double ring =
      models::kPi * (pad.outer_radius_m * pad.outer_radius_m - pad.inner_radius_m() * pad.inner_radius_m());
  const double letter = 2.0 * pad.h_height_m * pad.h_stroke_m + (pad.h_width_m - 2.0 * pad.h_stroke_m) * pad.h_stroke_m;
  EXPECT_NEAR(InkedArea(PaintPad(pad, 1024, 512), pad), ring + letter, 0.001 * (ring + letter));
}

TEST(PaintPad, InksASolidRectangle) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  const double ring =
      models::kPi * (pad.outer_radius_m * pad.outer_radius_m - pad.inner_radius_m() * pad.inner_radius_m());
  const double area = ring + pad.h_height_m * pad.h_width_m;
  EXPECT_NEAR(InkedArea(PaintPad(pad, 1024, 512), pad), area, 0.001 * area);
}

/// Pad with two markings that do not touch its other shapes.
models::LandingPad MarkedPad() {
  models::LandingPad pad;
  pad.marks = {{.shape = models::PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01},
               {.shape = models::PadMarking::Shape::kBar,
                .center_m = {-0.02, 0.05},
                .length_m = 0.02,
                .width_m = 0.004,
                .angle_deg = 30.0}};
  return pad;
}

TEST(PaintPad, InksTheMarkings) {
  const models::LandingPad pad = MarkedPad();
  const double marks = InkedArea(PaintPad(pad, 2048, 1448), pad) - InkedArea(PaintPad({}, 2048, 1448), {});
  const double disc = models::kPi * 0.005 * 0.005, bar = 0.02 * 0.004;
  EXPECT_NEAR(marks, disc + bar, 0.01 * (disc + bar));
}

TEST(PaintPad, AgreesWithThePadOutlineAwayFromEdges) {
  const models::LandingPad pad = MarkedPad();
  const models::PadOutline outline(pad);
  const cv::Mat1b artwork = PaintPad(pad, 512, 256);
  int gray = 0;
  for (int row = 0; row < artwork.rows; ++row) {
    for (int column = 0; column < artwork.cols; ++column) {
      const Eigen::Vector2d p(((column + 0.5) / 512 - 0.5) * pad.sheet_length_m,
                              (0.5 - (row + 0.5) / 256) * pad.sheet_width_m);
      const int level = artwork(row, column);
      if (level == kPaper || level == kInk) {
        EXPECT_EQ(level == kInk, outline.IsBlack(p));
      } else {
        ++gray;
      }
    }
  }
  EXPECT_GT(gray, 500);
  EXPECT_LT(gray, 6000);
}

TEST(PaintSheet, HasNothingInTheMiddleOfALoneRing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const SceneItem ring{.kind = SceneItem::Kind::kRing, .size_m = {0.2, 0.16, 0.0}, .texture_seed = seed};
    const cv::Mat1b artwork = PaintSheet(ring, 256, 256);
    const std::uint8_t middle = artwork(128, 128);
    EXPECT_GT(middle, 150);
    for (int row = 96; row < 160; ++row) {
      for (int column = 96; column < 160; ++column) EXPECT_EQ(artwork(row, column), middle);
    }
    const int ink = *std::min_element(artwork.ptr(128), artwork.ptr(128) + 256);
    EXPECT_LT(ink, 70);
  }
}

TEST(PaintSheet, DrawsALetterOfThreeBarsAndNoRing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const SceneItem letter{.kind = SceneItem::Kind::kLetterH, .size_m = {0.2, 0.16, 0.0}, .texture_seed = seed};
    const cv::Mat1b artwork = PaintSheet(letter, 256, 256);
    const int paper = artwork(2, 2);
    EXPECT_LT(artwork(128, 128), 70);
    EXPECT_EQ(artwork(128, 50), paper) << "between the strokes, left of the cross-bar";
    EXPECT_EQ(artwork(128, 206), paper) << "between the strokes, right of the cross-bar";
    for (int i = 0; i < 256; ++i) {
      EXPECT_EQ(artwork(2, i), paper);
      EXPECT_EQ(artwork(253, i), paper);
    }
  }
}

TEST(PaintSheet, DiffersFromSeedToSeed) {
  const auto poster = [](std::uint64_t seed) {
    return PaintSheet({.kind = SceneItem::Kind::kPoster, .size_m = {0.4, 0.3, 0.0}, .texture_seed = seed}, 128, 128);
  };
  EXPECT_EQ(cv::norm(poster(1), poster(1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(poster(1), poster(2), cv::NORM_INF), 20.0);
}

TEST(PaintSheet, FillsPostersWithTexture) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const SceneItem poster{.kind = SceneItem::Kind::kPoster, .size_m = {0.4, 0.3, 0.0}, .texture_seed = seed};
    cv::Scalar mean, deviation;
    cv::meanStdDev(PaintSheet(poster, 256, 256), mean, deviation);
    EXPECT_GT(deviation[0], 12.0) << seed;
  }
}

TEST(FloorPattern, IsTexturedForEveryKind) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FloorPattern pattern(seed);
    double sum = 0.0, sum_of_squares = 0.0;
    constexpr int kSide = 60;
    for (int i = 0; i < kSide * kSide; ++i) {
      const int column = i % kSide, row = i / kSide;
      const double level = pattern.At({0.02 * column, 0.02 * row});
      EXPECT_GE(level, 0.0);
      EXPECT_LE(level, 255.0);
      sum += level / (kSide * kSide);
      sum_of_squares += level * level / (kSide * kSide);
    }
    EXPECT_GT(std::sqrt(sum_of_squares - sum * sum), 8.0) << seed;
  }
}

}  // namespace
}  // namespace touchdown::sim
