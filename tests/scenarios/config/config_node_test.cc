#include "scenarios/config/config_node.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

namespace touchdown::config {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// The message of the error that `act` throws; a failure when it throws none.
template <typename Act>
std::string ErrorOf(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

std::string ParseError(const std::string& text) {
  return ErrorOf([&text] { ParseConfig(text, "f.yaml", ""); });
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

TEST(ConfigNode, KeepsKeysListsTextAndTheirLines) {
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

TEST(ConfigNode, RefusesADuplicateKeyAndNamesBothLines) {
  EXPECT_THAT(ParseError("a:\n  b: 1\n  b: 2\n"),
              AllOf(StartsWith("f.yaml:3: b: duplicate key"), HasSubstr("f.yaml:2")));
}

TEST(ConfigNode, ReadsAHundredThousandKeysInNoTime) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "k" + std::to_string(i) + ":\n";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(ParseError(text + "k7:\n"), StartsWith("f.yaml:100001: k7: duplicate key, first given at f.yaml:8"));
  // A second here; over a minute when every key is held against every other.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(ConfigNode, AllowsTheSameKeyInDifferentSections) {
  EXPECT_EQ(ParseConfig("a: {x: 1}\nb: {x: 2}\n", "f", "").Find("b")->Find("x")->text, "2");
}

TEST(ConfigNode, RefusesWhatIsNotAMapOfPlainKeys) {
  EXPECT_THAT(ParseError(""), HasSubstr("f.yaml:1: is empty"));
  EXPECT_THAT(ParseError("# only a comment\n"), HasSubstr("is empty"));
  EXPECT_THAT(ParseError("[1, 2]"), HasSubstr("f.yaml:1: must be a list of `key: value`"));
  EXPECT_THAT(ParseError("just text"), HasSubstr("must be a list of `key: value`"));
  EXPECT_THAT(ParseError("[a, b]: 1\n"), HasSubstr("a key must be plain text"));
  EXPECT_THAT(ParseError(": 1\n"), HasSubstr("a key must be plain text"));
}

TEST(ConfigNode, RefusesAnchorsAliasesTagsAndSecondDocuments) {
  EXPECT_THAT(ParseError("a: &x 1\n"), HasSubstr("anchors"));
  EXPECT_THAT(ParseError("b: 1\na: *x\n"), HasSubstr("f.yaml:2"));
  EXPECT_THAT(ParseError("a: !!float 1\n"), HasSubstr("tags"));
  EXPECT_THAT(ParseError("a: 1\n---\nb: 2\n"), HasSubstr("one YAML document"));
}

TEST(ConfigNode, RefusesABrokenFileWithTheLine) {
  EXPECT_THAT(ParseError("a: 1\nb: [1, 2\n"), AllOf(StartsWith("f.yaml:"), HasSubstr("is not YAML")));
  EXPECT_THAT(ParseError("a: 1\n\tb: 2\n"), HasSubstr("f.yaml:2"));
}

TEST(ConfigNode, SurvivesAHundredThousandBrackets) {
  const std::string open(100000, '['), close(100000, ']');
  EXPECT_THAT(ParseError("a: " + open + close), StartsWith("f.yaml:1: nested more than"));
  for (const std::string& text : {"a: " + open, open, "a: " + std::string(100000, '{')}) {
    EXPECT_EQ(ParseError(text), "f.yaml:1: a key must be plain text; is a bracket not closed?");
  }
  std::string blocks;
  for (int i = 0; i < 3000; ++i) blocks += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(ParseError(blocks), HasSubstr("nested more than"));
}

TEST(ConfigNode, PutsEveryErrorOnOneShortLine) {
  const std::string message =
      ConfigError({"file\nname:1", {}}, "a\nb", "x\r\n\x1b[31m" + std::string(5000, 'y')).what();
  EXPECT_THAT(message, AllOf(Not(HasSubstr("\n")), Not(HasSubstr("\x1b"))));
  EXPECT_LT(message.size(), 1000u);
}

TEST_F(ConfigFile, NamesAFileThatIsMissingAFolderOrNoText) {
  EXPECT_THAT(ErrorOf([&] { ReadConfigFile(folder_ / "none.yaml"); }), HasSubstr("none.yaml: no such file"));
  EXPECT_THAT(ErrorOf([&] { ReadConfigFile(folder_); }), HasSubstr("is a folder"));
  const fs::path binary = Put("binary.yaml", std::string("\x7f"
                                                         "ELF\0\0\1\2\3",
                                                         9));
  EXPECT_THAT(ErrorOf([&] { ReadConfigFile(binary); }), HasSubstr("binary.yaml"));
  const fs::path huge = Put("huge.yaml", "a: " + std::string(2 << 20, 'x'));
  EXPECT_THAT(ErrorOf([&] { ReadConfigFile(huge); }), HasSubstr("larger than 1 MiB"));
}

TEST_F(ConfigFile, IsUtf8) {
  EXPECT_EQ(ParseConfig("a: caf\u00e9 \U0001f681\nb: \"\\xe9\"\n", "f.yaml", "").Find("b")->text, "\u00e9");
  EXPECT_EQ(ParseError("a: 1\n\nb: caf\xe9\n"), "f.yaml:3: is not UTF-8");
  EXPECT_EQ(ErrorOf([] { ParseOverride("a=caf\xe9", "--set a"); }), "--set a: is not UTF-8");
  EXPECT_THAT(ErrorOf([&] { ReadConfigFile(Put("caf\xe9.yaml", "a: 1\n")); }), HasSubstr("its name is not UTF-8"));
}

TEST_F(ConfigFile, SurvivesAnyBytes) {
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

TEST(ParseOverride, NestsTheKeyAndMarksItAsAPatch) {
  const ConfigNode root = ParseOverride("events.0.force_n=[1, 2, 3]", "--force [1, 2, 3]");
  EXPECT_TRUE(root.patch);
  const ConfigNode& events = *root.Find("events");
  EXPECT_TRUE(events.patch);
  const ConfigNode& force = *events.Find("0")->Find("force_n");
  EXPECT_FALSE(force.patch);
  EXPECT_EQ(force.items.size(), 3u);
  EXPECT_EQ(force.origin.place, "--force [1, 2, 3]");
}

TEST(ParseOverride, TakesAValueWithAnEqualsSign) { EXPECT_EQ(ParseOverride("a=b=c", "--set").Find("a")->text, "b=c"); }

TEST(ParseOverride, RefusesWhatHasNoKey) {
  for (const char* text : {"", "a", "=1", ".=1", ".a=1", "a.=1", "a..b=1"}) {
    EXPECT_THROW(ParseOverride(text, "--set"), InputError) << text;
  }
  EXPECT_THROW(ParseOverride("a=[1", "--set"), InputError);
}

}  // namespace
}  // namespace touchdown::config
