#include "scenarios/config/config_node.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

#include "tests/support/throws_input_error.h"

namespace touchdown::config {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tests::ThrowsInputError;

auto Parsing(const std::string& text) {
  return [text] { ParseConfig(text, "f.yaml", ""); };
}

class ConfigFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path Put(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("config_node_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST(ConfigNode, KeepsKeysListsTextAndLines) {
  const ConfigNode root = ParseConfig("a: 1\nb:\n  c: [x, \"2\"]\n", "f.yaml", "here");
  ASSERT_EQ(root.kind, ConfigNode::Kind::kKeys);
  EXPECT_EQ(root.Find("a")->text, "1");
  EXPECT_FALSE(root.Find("a")->quoted);
  const ConfigNode& list = *root.Find("b")->Find("c");
  ASSERT_EQ(list.items.size(), 2u);
  EXPECT_EQ(list.items[1].text, "2");
  EXPECT_TRUE(list.items[1].quoted);
  EXPECT_EQ(list.origin.place, "f.yaml:3");
  EXPECT_EQ(list.origin.folder, "here");
  EXPECT_EQ(root.Find("absent"), nullptr);
}

TEST(ConfigNode, RejectsDuplicateKeyWithBothLines) {
  EXPECT_THAT(Parsing("a:\n  b: 1\n  b: 2\n"),
              ThrowsInputError(AllOf(StartsWith("f.yaml:3: b: duplicate key"), HasSubstr("f.yaml:2"))));
}

TEST(ConfigNode, ReadsHundredThousandKeysQuickly) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "k" + std::to_string(i) + ":\n";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(Parsing(text + "k7:\n"),
              ThrowsInputError(StartsWith("f.yaml:100001: k7: duplicate key, first given at f.yaml:8")));
  // The test takes about a second. A quadratic algorithm would take over a minute.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(ConfigNode, AllowsSameKeyInDifferentSections) {
  EXPECT_EQ(ParseConfig("a: {x: 1}\nb: {x: 2}\n", "f", "").Find("b")->Find("x")->text, "2");
}

TEST(ConfigNode, RejectsRootThatIsNotAMapOfPlainKeys) {
  EXPECT_THAT(Parsing(""), ThrowsInputError(HasSubstr("f.yaml:1: is empty")));
  EXPECT_THAT(Parsing("# only a comment\n"), ThrowsInputError(HasSubstr("is empty")));
  EXPECT_THAT(Parsing("[1, 2]"), ThrowsInputError(HasSubstr("f.yaml:1: must be a list of `key: value`")));
  EXPECT_THAT(Parsing("just text"), ThrowsInputError(HasSubstr("must be a list of `key: value`")));
  EXPECT_THAT(Parsing("[a, b]: 1\n"), ThrowsInputError(HasSubstr("a key must be plain text")));
  EXPECT_THAT(Parsing(": 1\n"), ThrowsInputError(HasSubstr("a key must be plain text")));
}

TEST(ConfigNode, RejectsAnchorsAliasesTagsAndSecondDocuments) {
  EXPECT_THAT(Parsing("a: &x 1\n"), ThrowsInputError(HasSubstr("anchors")));
  EXPECT_THAT(Parsing("b: 1\na: *x\n"), ThrowsInputError(HasSubstr("f.yaml:2")));
  EXPECT_THAT(Parsing("a: !!float 1\n"), ThrowsInputError(HasSubstr("tags")));
  EXPECT_THAT(Parsing("a: 1\n---\nb: 2\n"), ThrowsInputError(HasSubstr("one YAML document")));
}

TEST(ConfigNode, RejectsInvalidFileWithLine) {
  EXPECT_THAT(Parsing("a: 1\nb: [1, 2\n"), ThrowsInputError(AllOf(StartsWith("f.yaml:"), HasSubstr("is not YAML"))));
  EXPECT_THAT(Parsing("a: 1\n\tb: 2\n"), ThrowsInputError(HasSubstr("f.yaml:2")));
}

TEST(ConfigNode, RejectsHundredThousandBrackets) {
  const std::string open(100000, '['), close(100000, ']');
  EXPECT_THAT(Parsing("a: " + open + close), ThrowsInputError(StartsWith("f.yaml:1: nested more than")));
  for (const std::string& text : {"a: " + open, open, "a: " + std::string(100000, '{')}) {
    EXPECT_THAT(Parsing(text), ThrowsInputError("f.yaml:1: a key must be plain text; is a bracket not closed?"));
  }
  std::string blocks;
  for (int i = 0; i < 3000; ++i) blocks += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(Parsing(blocks), ThrowsInputError(HasSubstr("nested more than")));
}

TEST(ConfigNode, PrintsErrorsOnOneShortLine) {
  const std::string message =
      ConfigError({"file\nname:1", {}}, "a\nb", "x\r\n\x1b[31m" + std::string(5000, 'y')).what();
  EXPECT_THAT(message, AllOf(Not(HasSubstr("\n")), Not(HasSubstr("\x1b"))));
  EXPECT_LT(message.size(), 1000u);
}

TEST_F(ConfigFile, RejectsMissingFileFolderAndBinaryFile) {
  EXPECT_THAT([&] { ReadConfigFile(folder_ / "none.yaml"); }, ThrowsInputError(HasSubstr("none.yaml: no such file")));
  EXPECT_THAT([&] { ReadConfigFile(folder_); }, ThrowsInputError(HasSubstr("is a folder")));
  const fs::path binary = Put("binary.yaml", std::string("\x7f"
                                                         "ELF\0\0\1\2\3",
                                                         9));
  EXPECT_THAT([&] { ReadConfigFile(binary); }, ThrowsInputError(HasSubstr("binary.yaml")));
  const fs::path huge = Put("huge.yaml", "a: " + std::string(2 << 20, 'x'));
  EXPECT_THAT([&] { ReadConfigFile(huge); }, ThrowsInputError(HasSubstr("larger than 1 MiB")));
}

TEST_F(ConfigFile, MustBeUtf8) {
  EXPECT_EQ(ParseConfig("a: caf\u00e9 \U0001f681\nb: \"\\xe9\"\n", "f.yaml", "").Find("b")->text, "\u00e9");
  EXPECT_THAT(Parsing("a: 1\n\nb: caf\xe9\n"), ThrowsInputError("f.yaml:3: is not UTF-8"));
  EXPECT_THAT([] { ParseOverride("a=caf\xe9", "--set a"); }, ThrowsInputError("--set a: is not UTF-8"));
  EXPECT_THAT([&] { ReadConfigFile(Put("caf\xe9.yaml", "a: 1\n")); },
              ThrowsInputError(HasSubstr("the file name is not UTF-8")));
}

TEST_F(ConfigFile, HandlesArbitraryBytes) {
  for (int seed = 0; seed < 300; ++seed) {
    std::string bytes;
    unsigned state = static_cast<unsigned>(seed) * 2654435761u + 1u;
    for (int i = 0; i < 200; ++i) {
      state = state * 1664525u + 1013904223u;
      bytes += static_cast<char>(seed % 2 == 0 ? state >> 24 : "[]{}:,-&*!|>'\"%@` \n\tab1"[(state >> 24) % 24]);
    }
    try {
      ParseConfig(bytes, "f", "");
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    }
  }
}

TEST(ParseOverride, NestsKeyAndMarksItAsPatch) {
  const ConfigNode root = ParseOverride("events.0.force_n=[1, 2, 3]", "--force [1, 2, 3]");
  EXPECT_TRUE(root.patch);
  const ConfigNode& events = *root.Find("events");
  EXPECT_TRUE(events.patch);
  const ConfigNode& force = *events.Find("0")->Find("force_n");
  EXPECT_FALSE(force.patch);
  EXPECT_EQ(force.items.size(), 3u);
  EXPECT_EQ(force.origin.place, "--force [1, 2, 3]");
}

TEST(ParseOverride, AcceptsValueWithEqualsSign) { EXPECT_EQ(ParseOverride("a=b=c", "--set").Find("a")->text, "b=c"); }

TEST(ParseOverride, RejectsMissingKey) {
  for (const char* text : {"", "a", "=1", ".=1", ".a=1", "a.=1", "a..b=1"}) {
    EXPECT_THROW(ParseOverride(text, "--set"), InputError) << text;
  }
  EXPECT_THROW(ParseOverride("a=[1", "--set"), InputError);
}

}  // namespace
}  // namespace touchdown::config
