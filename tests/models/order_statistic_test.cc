#include "models/order_statistic.h"

#include <gtest/gtest.h>

namespace touchdown::models {
namespace {

TEST(OrderStatistic, ReturnsTheValueOfARank) {
  const std::vector<double> values{3.0, 1.0, 2.0, 1.0};
  for (const auto& [rank, value] : {std::pair(0, 1.0), {1, 1.0}, {2, 2.0}, {3, 3.0}}) {
    EXPECT_EQ(OrderStatistic(values, static_cast<std::size_t>(rank)), value) << rank;
  }
}

TEST(UpperMedian, IsTheLargerOfTheMiddleTwo) {
  EXPECT_EQ(UpperMedian(std::vector{5.0}), 5.0);
  EXPECT_EQ(UpperMedian(std::vector{3.0F, 1.0F, 2.0F}), 2.0F);
  EXPECT_EQ(UpperMedian(std::vector{4.0, 1.0, 3.0, 2.0}), 3.0);
}

}  // namespace
}  // namespace touchdown::models
