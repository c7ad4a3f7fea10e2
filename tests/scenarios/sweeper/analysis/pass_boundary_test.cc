#include "scenarios/sweeper/analysis/pass_boundary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/random_stream.h"

namespace touchdown::sweeper {
namespace {

/// Logistic pass rate that falls from 0.99 to 0 around the value 6.
double PassRate(double value, double width) { return 0.99 / (1.0 + std::exp((value - 6.0) / width)); }
/// Value at which the pass rate is `level`.
double TrueBoundary(double level, double width) { return 6.0 + width * std::log(0.99 / level - 1.0); }

PassBoundary AfterGrid(double level, double width, int each, std::uint64_t seed) {
  models::RandomStream random(seed, "pass_edge_test");
  PassBoundary posterior(0.0, 12.0, level);
  for (int value = 0; value <= 12; value += 2) {
    for (int i = 0; i < each; ++i) {
      const bool passed = random.Bernoulli(PassRate(value, width));
      posterior.Add(value, passed ? 1 : 0, passed ? 0 : 1);
    }
  }
  return posterior;
}

TEST(PassBoundary, SpansTheRangeWithoutFlights) {
  const util::Interval boundary = PassBoundary(0.0, 12.0, 0.5).boundary();
  EXPECT_NEAR(boundary.value, 6.0, 0.2);
  EXPECT_LT(boundary.low, 0.5);
  EXPECT_GT(boundary.high, 11.5);
}

TEST(PassBoundary, IntervalContainsTheTrueBoundaryWithItsProbability) {
  for (const double level : {0.5, 0.9}) {
    int contained = 0;
    constexpr int kSearches = 60;
    for (int seed = 0; seed < kSearches; ++seed) {
      const util::Interval boundary = AfterGrid(level, 0.8, 10, static_cast<std::uint64_t>(seed)).boundary();
      contained += boundary.low <= TrueBoundary(level, 0.8) && TrueBoundary(level, 0.8) <= boundary.high ? 1 : 0;
    }
    // 57 of 60 are expected. 50 or fewer have a probability below 1 %. The prior differs from the true distribution.
    EXPECT_GE(contained, 51) << level;
  }
}

TEST(PassBoundary, NarrowsWithTheNumberOfFlights) {
  const util::Interval few = AfterGrid(0.5, 0.8, 3, 1).boundary(), many = AfterGrid(0.5, 0.8, 40, 1).boundary();
  EXPECT_LT(many.high - many.low, 0.6 * (few.high - few.low));
  EXPECT_NEAR(many.value, TrueBoundary(0.5, 0.8), 0.4);
}

TEST(PassBoundary, FindsABoundaryFromFailureToSuccess) {
  PassBoundary posterior(0.0, 12.0, 0.5);
  for (int i = 0; i < 120; ++i) posterior.Add(0.1 * i, 0.1 * i > 4.0 ? 1 : 0, 0.1 * i > 4.0 ? 0 : 1);
  EXPECT_NEAR(posterior.boundary().value, 4.0, 0.2);
  EXPECT_LT(posterior.boundary().high - posterior.boundary().low, 0.6);
}

TEST(PassBoundary, ReachesTheEndOfTheRangeIfAllFlightsPass) {
  PassBoundary posterior(0.0, 12.0, 0.5);
  for (int i = 0; i <= 24; ++i) posterior.Add(0.5 * i, 1, 0);
  EXPECT_EQ(posterior.boundary().high, 12.0);
  for (const auto& [min, max] : {std::pair(0.2, 0.9), {0.4, 1.8}, {-2.0, -0.6}}) {
    PassBoundary other(min, max, 0.5);
    for (int i = 0; i <= 24; ++i) other.Add(std::lerp(min, max, i / 24.0), 1, 0);
    EXPECT_EQ(other.boundary().high, max) << "to the last bit";
  }
}

}  // namespace
}  // namespace touchdown::sweeper
