#include "scenarios/util/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::util {
namespace {

using ::testing::HasSubstr;
using tests::ThrowsInputError;

TEST(ReadTextFile, ReadsEveryByte) {
  const tests::TemporaryFolder folder;
  std::string content = std::string("a\0b\r\n", 5) + "\xff";
  content.resize(200'000, 'x');
  EXPECT_EQ(ReadTextFile(folder.Put("file", content)), content);
  EXPECT_EQ(ReadTextFile(folder.Put("empty", "")), "");
}

TEST(ReadTextFile, ReportsFileAndCauseOnFailure) {
  const tests::TemporaryFolder folder;
  EXPECT_THAT([&] { ReadTextFile(folder / "none"); },
              ThrowsInputError(HasSubstr("none: cannot be read: No such file")));
  EXPECT_THAT([&] { ReadTextFile(folder.path()); }, ThrowsInputError(HasSubstr(": cannot be read: Is a directory")));
}

TEST(ReadTextFileIfPresent, ReturnsNulloptOnlyForMissingFile) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(ReadTextFileIfPresent(folder.Put("file", "text")), "text");
  EXPECT_EQ(ReadTextFileIfPresent(folder / "none"), std::nullopt);
  EXPECT_EQ(ReadTextFileIfPresent(folder / "file" / "in it"), std::nullopt);
  EXPECT_THROW(ReadTextFileIfPresent(folder.path()), InputError);
}

}  // namespace
}  // namespace touchdown::util
