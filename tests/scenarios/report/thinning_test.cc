#include "scenarios/report/thinning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace touchdown::report {
namespace {

using Rows = std::vector<std::size_t>;

constexpr std::size_t kBuckets = 10;

/// Random values with gaps.
Series RandomSeries(std::size_t rows, std::mt19937& random) {
  Series series(rows);
  for (std::optional<double>& value : series) {
    if (random() % 5 != 0) value = static_cast<double>(random() % 2000) / 10.0;
  }
  return series;
}

/// Smallest and largest value in rows `begin` to `end` - 1.
std::pair<std::optional<double>, std::optional<double>> Extremes(const Series& series, std::size_t begin,
                                                                 std::size_t end) {
  std::optional<double> smallest, largest;
  for (std::size_t i = begin; i < end; ++i) {
    if (!series[i]) continue;
    smallest = std::min(smallest.value_or(*series[i]), *series[i]);
    largest = std::max(largest.value_or(*series[i]), *series[i]);
  }
  return {smallest, largest};
}

TEST(Thinning, KeepsAllRowsOfShortSeries) {
  EXPECT_THAT(ThinnedRows(std::vector<Series>{{1.0, std::nullopt, 2.0}}, kBuckets), testing::ElementsAre(0, 1, 2));
  EXPECT_TRUE(ThinnedRows(std::vector<Series>{{}}, kBuckets).empty());
  EXPECT_TRUE(ThinnedRows({}, kBuckets).empty());
}

TEST(Thinning, KeepsExtremesOfEachSeriesInEachBucket) {
  std::mt19937 random(1);
  for (int repetition = 0; repetition < 100; ++repetition) {
    const std::size_t rows = 50 + random() % 2000;
    const std::vector<Series> series = {RandomSeries(rows, random), RandomSeries(rows, random)};
    const Rows kept = ThinnedRows(series, kBuckets);
    ASSERT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    for (const Series& one : series) {
      Series thinned(rows);
      for (const std::size_t row : kept) thinned[row] = one[row];
      for (std::size_t i = 0; i < kBuckets; ++i) {
        const std::size_t begin = i * rows / kBuckets, end = (i + 1) * rows / kBuckets;
        ASSERT_EQ(Extremes(thinned, begin, end), Extremes(one, begin, end));
      }
    }
  }
}

TEST(Thinning, KeepsSpikesAndFewOtherRows) {
  std::mt19937 random(2);
  for (int repetition = 0; repetition < 100; ++repetition) {
    const std::size_t rows = 100 + random() % 3000, at = random() % rows;
    Series spike(rows, 1.0);
    spike[at] = 7.0;
    const Rows kept = ThinnedRows(std::vector<Series>{Series(rows, 0.0), spike}, kBuckets);
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), at));
    EXPECT_LE(kept.size(), 4 * kBuckets + 2);
  }
}

TEST(Thinning, KeepsRowsAtGapBoundaries) {
  Series series(1000, 1.0);
  for (std::size_t i = 333; i < 444; ++i) series[i] = std::nullopt;
  const Rows kept = ThinnedRows(std::vector<Series>{series}, kBuckets);
  EXPECT_THAT(kept, testing::IsSupersetOf({0u, 332u, 333u, 443u, 444u, 999u}));
  EXPECT_LT(kept.size(), 30u);
}

}  // namespace
}  // namespace touchdown::report
