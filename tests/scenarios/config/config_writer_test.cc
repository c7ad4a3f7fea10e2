#include "scenarios/config/config_writer.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "models/random_stream.h"

namespace touchdown::config {
namespace {

double Read(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(WriteNumber, UsesFewestDigits) {
  EXPECT_EQ(WriteNumber(4.0), "4");
  EXPECT_EQ(WriteNumber(-1.5), "-1.5");
  EXPECT_EQ(WriteNumber(0.1), "0.1");
  EXPECT_EQ(WriteNumber(0.0), "0");
}

TEST(WriteNumber, ReadsBackBitIdentical) {
  models::RandomStream random(7, "test.numbers");
  for (int i = 0; i < 20000; ++i) {
    const double value = random.Normal() * std::pow(10.0, random.UniformInt(-9, 9));
    EXPECT_EQ(Read(WriteNumber(value)), value);
  }
}

TEST(WriteText, EscapesSpecialCharacters) {
  for (const std::string text : {"plain", "a: b", "\"quoted\" \\ back", "two\nlines", "", "#no", "tab\t", "Grüße"}) {
    const ConfigNode root = ParseConfig("key: " + WriteText(text) + "\n", "f", "");
    EXPECT_EQ(root.Find("key")->text, text);
    EXPECT_TRUE(root.Find("key")->quoted);
  }
}

}  // namespace
}  // namespace touchdown::config
