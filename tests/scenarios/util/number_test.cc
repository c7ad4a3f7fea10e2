#include "scenarios/util/number.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace touchdown::util {
namespace {

TEST(FiniteNumber, ReadsWholeToken) {
  EXPECT_EQ(FiniteNumber("-1.5e3"), -1500.0);
  EXPECT_EQ(FiniteNumber<int>("-7"), -7);
  EXPECT_EQ(FiniteNumber<std::int64_t>("1403636579763555584"), 1403636579763555584);
  for (const char* token : {"", "one", "1.5x", " 1", "1 ", "+1", "nan", "inf", "1e999"}) {
    EXPECT_EQ(FiniteNumber(token), std::nullopt) << token;
  }
  for (const char* token : {"", "1.5", "-1", "4294967296"}) {
    EXPECT_EQ(FiniteNumber<std::uint32_t>(token), std::nullopt) << token;
  }
}

TEST(FiniteNumber, ReadsSubnormalNumbersExactly) {
  EXPECT_EQ(FiniteNumber("1e-310"), 1e-310);
  EXPECT_EQ(FiniteNumber("5e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(ReadNumber, DistinguishesTooLargeNumbersFromOtherText) {
  EXPECT_TRUE(ReadNumber<double>("1e999").is_out_of_range);
  EXPECT_TRUE(ReadNumber<std::int64_t>("9223372036854775808").is_out_of_range);
  EXPECT_FALSE(ReadNumber<double>("one").is_out_of_range);
  EXPECT_FALSE(ReadNumber<double>("1e999x").is_out_of_range);
}

}  // namespace
}  // namespace touchdown::util
