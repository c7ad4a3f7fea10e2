#include "scenarios/config/config_writer.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "models/random_stream.h"

namespace touchdown::config {
namespace {

double Read(const std::string& text, const Unit& unit) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return unit.ToSi(value);
}

TEST(WriteNumber, IsWhatAPersonWouldWrite) {
  EXPECT_EQ(WriteNumber(0.004, kMillisecond), "4");
  EXPECT_EQ(WriteNumber(kDegree.ToSi(30.0), kDegree), "30");
  EXPECT_EQ(WriteNumber(kDegree.ToSi(-1.5), kDegree), "-1.5");
  EXPECT_EQ(WriteNumber(0.1, kMetre), "0.1");
  EXPECT_EQ(WriteNumber(0.0, kDegree), "0");
}

TEST(WriteNumber, ReadsBackToTheSameBits) {
  models::RandomStream random(7, "test.numbers");
  for (int i = 0; i < 20000; ++i) {
    const double written = random.Normal() * std::pow(10.0, random.UniformInt(-9, 9));
    for (const Unit& unit : {kMetre, kMillisecond, kDegree}) {
      const double si = unit.ToSi(written);
      EXPECT_EQ(Read(WriteNumber(si, unit), unit), si) << written << ' ' << unit.name;
    }
  }
}

TEST(WriteText, EscapesWhatYamlWouldTakeForItsOwn) {
  for (const std::string text : {"plain", "a: b", "\"quoted\" \\ back", "two\nlines", "", "#no", "tab\t", "Grüße"}) {
    const ConfigNode root = ParseConfig("key: " + WriteText(text) + "\n", "f", "");
    EXPECT_EQ(root.Find("key")->text, text);
    EXPECT_TRUE(root.Find("key")->quoted);
  }
}

}  // namespace
}  // namespace touchdown::config
