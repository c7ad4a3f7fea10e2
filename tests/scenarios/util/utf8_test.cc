#include "scenarios/util/utf8.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace touchdown::util {
namespace {

TEST(Utf8, CountsBytesBeforeFirstInvalidByte) {
  EXPECT_EQ(Utf8Bytes(""), 0u);
  EXPECT_EQ(Utf8Bytes("plain"), 5u);
  EXPECT_EQ(Utf8Bytes("caf\u00e9 \u20ac \U0001f681"), 14u);
  EXPECT_EQ(Utf8Bytes("caf\xe9 at noon"), 3u) << "Latin 1";
  EXPECT_EQ(Utf8Bytes("caf\xc3"), 3u) << "cut short";
  EXPECT_EQ(Utf8Bytes("\xc0\xaf"), 0u) << "longer than it must be";
  EXPECT_EQ(Utf8Bytes("\xed\xa0\x80"), 0u) << "half a pair of UTF-16";
  EXPECT_EQ(Utf8Bytes("\xf4\x90\x80\x80"), 0u) << "past Unicode's end";
}

TEST(Utf8, AgreesWithJsonLibrary) {
  std::mt19937 random(1);
  // Bytes at the limits of the valid ranges.
  const std::string bytes =
      "a\x7f\x80\x8f\x90\x9f\xa0\xbf\xc0\xc1\xc2\xdf\xe0\xe1\xec\xed\xee\xef\xf0\xf1\xf3\xf4\xf5\xff";
  int valid = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text(1 + random() % 4, '\0');
    for (char& c : text) c = bytes[random() % bytes.size()];
    const bool is_utf8 = Utf8Bytes(text) == text.size();
    bool is_json = true;
    try {
      nlohmann::json(text).dump();
    } catch (const nlohmann::json::exception&) {
      is_json = false;
    }
    ASSERT_EQ(is_utf8, is_json);
    valid += is_utf8 ? 1 : 0;
  }
  EXPECT_GT(valid, 1000);
}

}  // namespace
}  // namespace touchdown::util
