#include "scenarios/util/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::util {
namespace {

TEST(Statistics, MatchKnownValues) {
  const std::vector<double> values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  EXPECT_DOUBLE_EQ(Mean(values), 5.0);
  EXPECT_NEAR(StandardDeviation(values), 2.13809, 1e-5);
  EXPECT_NEAR(RootMeanSquare(values), 5.38516, 1e-5);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.5), 4.5);
  EXPECT_DOUBLE_EQ(Quantile(values, 1.0), 9.0);
  EXPECT_THROW(Mean({}), std::invalid_argument);
}

TEST(MeanInterval, MatchesStudentsT) {
  // t of 9 degrees of freedom at 97.5 %: 2.262 (any table).
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const Interval mean = MeanInterval(values);
  EXPECT_DOUBLE_EQ(mean.value, 5.5);
  EXPECT_NEAR(mean.high - mean.value, 2.262157 * 3.02765 / 3.162278, 1e-4);
  EXPECT_NEAR(mean.value - mean.low, mean.high - mean.value, 1e-12);
}

TEST(MeanInterval, CoversTrueMeanIn95PercentOfCases) {
  models::RandomStream random(1, "tests.mean_interval");
  constexpr int kCases = 4000;
  int covered = 0;
  for (int i = 0; i < kCases; ++i) {
    std::vector<double> values;
    for (int k = 0; k < 6; ++k) values.push_back(3.0 + 2.0 * random.Normal());
    const Interval mean = MeanInterval(values);
    covered += mean.low <= 3.0 && 3.0 <= mean.high ? 1 : 0;
  }
  EXPECT_NEAR(covered / static_cast<double>(kCases), 0.95, 0.012);
}

TEST(WilsonInterval, MatchesKnownValues) {
  // 10 of 100: 5.5 to 17.4 %; 0 of 100: up to 3.7 %.
  const Interval tenth = WilsonInterval(10, 100);
  EXPECT_DOUBLE_EQ(tenth.value, 0.1);
  EXPECT_NEAR(tenth.low, 0.0552, 5e-4);
  EXPECT_NEAR(tenth.high, 0.1744, 5e-4);
  const Interval none = WilsonInterval(0, 100);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.0370, 5e-4);
  EXPECT_EQ(WilsonInterval(7, 7).high, 1.0);
  EXPECT_THROW(WilsonInterval(1, 0), std::invalid_argument);
}

TEST(WilsonInterval, CoversTrueRateOfCorrelatedClusters) {
  EXPECT_EQ(WilsonInterval(40, 200, 20).low, WilsonInterval(4, 20).low);
  EXPECT_THROW(WilsonInterval(1, 2, 3), std::invalid_argument);
  models::RandomStream random(1, "tests.clusters");
  constexpr int kCases = 4000, kClusters = 20, kEach = 10;
  int covered = 0, naive_count = 0;
  for (int i = 0; i < kCases; ++i) {
    int successes = 0;
    for (int k = 0; k < kClusters; ++k) successes += random.Bernoulli(0.8) ? kEach : 0;
    const Interval interval = WilsonInterval(successes, kClusters * kEach, kClusters);
    const Interval naive = WilsonInterval(successes, kClusters * kEach);
    covered += interval.low <= 0.8 && 0.8 <= interval.high ? 1 : 0;
    naive_count += naive.low <= 0.8 && 0.8 <= naive.high ? 1 : 0;
  }
  EXPECT_GE(covered / static_cast<double>(kCases), 0.93);
  EXPECT_LE(naive_count / static_cast<double>(kCases), 0.6);
}

TEST(QuantileInterval, CoversTrueQuantileOfClustersOfEqualValues) {
  models::RandomStream random(2, "tests.clusters");
  constexpr int kCases = 2000, kClusters = 60;
  int covered = 0;
  for (int i = 0; i < kCases; ++i) {
    std::vector<double> values;
    for (int k = 0; k < kClusters; ++k) values.insert(values.end(), 3, random.Normal());
    const Interval median = QuantileInterval(values, 0.5, kClusters);
    covered += median.low <= 0.0 && 0.0 <= median.high ? 1 : 0;
  }
  EXPECT_GE(covered / static_cast<double>(kCases), 0.94);
  EXPECT_LE(covered / static_cast<double>(kCases), 0.99);
}

TEST(BinomialTail, MatchesKnownValues) {
  // Three coin throws: at least one head 7/8, at least two 4/8.
  EXPECT_NEAR(BinomialTail(1, 3, 0.5), 0.875, 1e-12);
  EXPECT_NEAR(BinomialTail(2, 3, 0.5), 0.5, 1e-12);
  EXPECT_EQ(BinomialTail(0, 3, 0.5), 1.0);
}

TEST(QuantileInterval, UsesTabulatedOrderStatistics) {
  // The median of ten is between the second and the ninth with 97.9 %, the third and the eighth with 89.1 %.
  const Interval median = QuantileInterval({7, 1, 4, 10, 2, 8, 3, 9, 6, 5}, 0.5, 10);
  EXPECT_DOUBLE_EQ(median.value, 5.5);
  EXPECT_DOUBLE_EQ(median.low, 2.0);
  EXPECT_DOUBLE_EQ(median.high, 9.0);
}

TEST(QuantileInterval, HasInfiniteUpperBoundWithTooFewValues) {
  // 0.95^71 is above 2.5 %, 0.95^72 is not.
  EXPECT_TRUE(std::isinf(QuantileInterval(std::vector<double>(71, 1.0), 0.95, 71).high));
  EXPECT_EQ(QuantileInterval(std::vector<double>(72, 1.0), 0.95, 72).high, 1.0);
  EXPECT_EQ(FewestForQuantile(0.95), 72);
  EXPECT_EQ(FewestForQuantile(0.05), 72);
  EXPECT_TRUE(std::isinf(QuantileInterval({1.0, 2.0}, 0.5, 2).low));
}

TEST(QuantileInterval, CoversTrueQuantileIn95PercentOfCases) {
  models::RandomStream random(1, "tests.quantile_interval");
  constexpr int kCases = 4000;
  int covered = 0;
  for (int i = 0; i < kCases; ++i) {
    std::vector<double> values;
    for (int k = 0; k < 120; ++k) values.push_back(random.Normal());
    const Interval quantile = QuantileInterval(values, 0.8, 120);
    const double truth = NormalQuantile(0.8);
    covered += quantile.low <= truth && truth <= quantile.high ? 1 : 0;
  }
  EXPECT_GE(covered / static_cast<double>(kCases), 0.94);
  EXPECT_LE(covered / static_cast<double>(kCases), 0.98);
}

}  // namespace
}  // namespace touchdown::util
