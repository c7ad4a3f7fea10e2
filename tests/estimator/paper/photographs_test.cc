// Recognition rates of docs/footage.md, on synthetic photographs that were not used during development.
#include <gtest/gtest.h>

#include <opencv2/core/utility.hpp>

#include "tests/support/photograph_score.h"

namespace touchdown::tests {
namespace {

constexpr std::uint64_t kFresh = 7'000'000;  ///< First seed that was not used for development.

class Photographs : public testing::Test {
 protected:
  void SetUp() override { cv::setNumThreads(1); }
};

TEST_F(Photographs, WithAPadAreRecognized) {
  constexpr int kPads = 100;
  int found = 0;
  for (std::uint64_t seed = kFresh; seed < kFresh + kPads; ++seed) found += Score(PhotographPad(seed)).found;
  EXPECT_GE(found, 0.95 * kPads);
}

TEST_F(Photographs, OfDistractorsAreRejected) {
  constexpr int kDistractors = 100;
  for (std::uint64_t seed = kFresh; seed < kFresh + kDistractors; ++seed) {
    const Photograph photo = PhotographDistractor(seed);
    EXPECT_FALSE(Score(photo).reports_pad) << photo.subject << ", seed " << seed;
  }
}

TEST_F(Photographs, AreTheSameForTheSameSeed) {
  EXPECT_EQ(PhotographPad(kFresh).image.pixels, PhotographPad(kFresh).image.pixels);
  EXPECT_NE(PhotographPad(kFresh).image.pixels, PhotographPad(kFresh + 1).image.pixels);
}

}  // namespace
}  // namespace touchdown::tests
