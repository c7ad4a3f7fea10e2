#include "scenarios/sweeper/analysis/pass_boundary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/random_stream.h"

namespace touchdown::sweeper {
namespace {

/// A pass rate that falls from 0.99 to 0 about 6, with this width.
double PassRate(double value, double width) { return 0.99 / (1.0 + std::exp((value - 6.0) / width)); }
/// Where it is `level`.
double TrueEdge(double level, double width) { return 6.0 + width * std::log(0.99 / level - 1.0); }

PassBoundary AfterGrid(double level, double width, int each, std::uint64_t seed) {
  models::RandomStream random(seed, "pass_edge_test");
  PassBoundary edge(0.0, 12.0, level);
  for (int value = 0; value <= 12; value += 2) {
    for (int i = 0; i < each; ++i) {
      const bool passed = random.Bernoulli(PassRate(value, width));
      edge.Take(value, passed ? 1 : 0, passed ? 0 : 1);
    }
  }
  return edge;
}

TEST(PassBoundary, KnowsNothingAtFirst) {
  const util::Interval edge = PassBoundary(0.0, 12.0, 0.5).edge();
  EXPECT_NEAR(edge.value, 6.0, 0.2);
  EXPECT_LT(edge.low, 0.5);
  EXPECT_GT(edge.high, 11.5);
}

TEST(PassBoundary, HoldsTheTrueEdgeNineteenTimesOfTwenty) {
  for (const double level : {0.5, 0.9}) {
    int held = 0;
    constexpr int kSearches = 60;
    for (int seed = 0; seed < kSearches; ++seed) {
      const util::Interval edge = AfterGrid(level, 0.8, 10, static_cast<std::uint64_t>(seed)).edge();
      held += edge.low <= TrueEdge(level, 0.8) && TrueEdge(level, 0.8) <= edge.high ? 1 : 0;
    }
    // 57 expected of 60; 50 or fewer have a probability below 1 %, and a prior is not the truth.
    EXPECT_GE(held, 51) << level;
  }
}

TEST(PassBoundary, NarrowsWithEveryFlightNearIt) {
  const util::Interval few = AfterGrid(0.5, 0.8, 3, 1).edge(), many = AfterGrid(0.5, 0.8, 40, 1).edge();
  EXPECT_LT(many.high - many.low, 0.6 * (few.high - few.low));
  EXPECT_NEAR(many.value, TrueEdge(0.5, 0.8), 0.4);
}

TEST(PassBoundary, FindsAnEdgeFromFailureToSuccessToo) {
  PassBoundary edge(0.0, 12.0, 0.5);
  for (int i = 0; i < 120; ++i) edge.Take(0.1 * i, 0.1 * i > 4.0 ? 1 : 0, 0.1 * i > 4.0 ? 0 : 1);
  EXPECT_NEAR(edge.edge().value, 4.0, 0.2);
  EXPECT_LT(edge.edge().high - edge.edge().low, 0.6);
}

TEST(PassBoundary, SaysThatTheEdgeMayLieBeyondWhereEveryFlightPasses) {
  PassBoundary edge(0.0, 12.0, 0.5);
  for (int i = 0; i <= 24; ++i) edge.Take(0.5 * i, 1, 0);
  EXPECT_EQ(edge.edge().high, 12.0);
  for (const auto& [min, max] : {std::pair(0.2, 0.9), {0.4, 1.8}, {-2.0, -0.6}}) {
    PassBoundary other(min, max, 0.5);
    for (int i = 0; i <= 24; ++i) other.Take(std::lerp(min, max, i / 24.0), 1, 0);
    EXPECT_EQ(other.edge().high, max) << "to the last bit";
  }
}

}  // namespace
}  // namespace touchdown::sweeper
