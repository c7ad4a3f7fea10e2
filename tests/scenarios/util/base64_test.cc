#include "scenarios/util/base64.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace touchdown::util {
namespace {

TEST(Base64, MatchesRfc4648) {
  const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(Base64(bytes), text);
    EXPECT_EQ(FromBase64(text), bytes);
  }
}

TEST(Base64, DecodesEveryByte) {
  std::string bytes;
  for (int i = 0; i < 1021; ++i) bytes += static_cast<char>(i * 7);
  EXPECT_EQ(FromBase64(Base64(bytes)), bytes);
}

TEST(Base64, RejectsInvalidText) { EXPECT_THROW(FromBase64("not base64!"), std::invalid_argument); }

}  // namespace
}  // namespace touchdown::util
