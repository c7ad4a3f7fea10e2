#include "scenarios/training/classifier_variation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "estimator/paper/classifier.h"

namespace touchdown::training {
namespace {

constexpr std::size_t kSide = estimator::paper::kPatternSide;

/// The letter L, which differs from all its mirror images and rotations.
std::vector<float> LetterL() {
  std::vector<float> pattern(kSide * kSide, 0.0F);
  for (std::size_t i = 0; i < kSide; ++i) {
    for (std::size_t j = 0; j < 4; ++j) pattern[i * kSide + j] = 1.0F;
    for (std::size_t j = kSide - 3; j < kSide; ++j) pattern[j * kSide + i] = 1.0F;
  }
  return pattern;
}

bool HasInk(const std::vector<float>& pattern, std::size_t begin, std::size_t step) {
  for (std::size_t i = 0; i < kSide; ++i) {
    if (pattern[begin + i * step] > 0.05F) return true;
  }
  return false;
}

TEST(VaryPattern, AppliesAllEightSymmetries) {
  models::RandomStream random(1, "test");
  const std::vector<float> letter = LetterL();
  std::set<std::vector<float>> unwarped;
  for (int i = 0; i < 400; ++i) {
    const std::vector<float> varied = VaryPattern(letter, random);
    const bool is_binary = std::all_of(varied.begin(), varied.end(), [](float x) { return x == 0.0F || x == 1.0F; });
    if (is_binary) unwarped.insert(varied);
  }
  EXPECT_EQ(unwarped.size(), 8U);
  EXPECT_TRUE(unwarped.contains(letter));
}

TEST(VaryPattern, TouchesAllSidesOfTheBoundingBox) {
  models::RandomStream random(2, "test");
  for (int i = 0; i < 200; ++i) {
    const std::vector<float> varied = VaryPattern(LetterL(), random);
    ASSERT_EQ(varied.size(), kSide * kSide);
    EXPECT_TRUE(HasInk(varied, 0, 1) && HasInk(varied, (kSide - 1) * kSide, 1));
    EXPECT_TRUE(HasInk(varied, 0, kSide) && HasInk(varied, kSide - 1, kSide));
    EXPECT_TRUE(std::all_of(varied.begin(), varied.end(), [](float x) { return x >= 0.0F && x <= 1.0F; }));
  }
}

TEST(VaryPattern, ApproximatelyKeepsTheAmountOfInk) {
  models::RandomStream random(3, "test");
  const std::vector<float> letter = LetterL();
  const float ink = std::accumulate(letter.begin(), letter.end(), 0.0F);
  for (int i = 0; i < 200; ++i) {
    const std::vector<float> varied = VaryPattern(letter, random);
    EXPECT_NEAR(std::accumulate(varied.begin(), varied.end(), 0.0F), ink, 0.35F * ink);
  }
}

TEST(VaryPattern, KeepsAnEmptyPatternEmpty) {
  models::RandomStream random(4, "test");
  const std::vector<float> empty(kSide * kSide, 0.0F);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(VaryPattern(empty, random), empty);
}

}  // namespace
}  // namespace touchdown::training
