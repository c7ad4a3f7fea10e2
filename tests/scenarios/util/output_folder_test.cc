#include "scenarios/util/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "models/error.h"

namespace touchdown::util {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

const FolderKind kKind = {.files = {"result.json", "log.csv"}, .signature = "\"schema\""};

class OutputFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::vector<std::string> Names(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    return names;
  }
  static void Put(const fs::path& file, const std::string& content) { std::ofstream(file) << content; }
  static std::string Content(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void Fill(const fs::path& place, const std::string& content) {
    OutputFolder folder(place, kKind);
    folder.Write("log.csv", content);
    folder.Write("result.json", "{\"schema\": 1}");
    folder.Commit();
  }

  const fs::path root_ =
      fs::path(::testing::TempDir()) /
      ("output_folder_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(OutputFolderTest, AppearsWithParentsOnCommit) {
  Fill(root_ / "a" / "b", "1");
  EXPECT_THAT(Names(root_ / "a" / "b"), UnorderedElementsAre("result.json", "log.csv"));
  EXPECT_THAT(Names(root_ / "a"), ElementsAre("b"));
}

TEST_F(OutputFolderTest, LeavesNothingWithoutCommit) {
  {
    OutputFolder folder(root_ / "a" / "b", kKind);
    folder.Write("result.json", "{}");
    EXPECT_FALSE(fs::exists(root_ / "a" / "b"));
  }
  EXPECT_THAT(Names(root_), IsEmpty());
}

TEST_F(OutputFolderTest, ReplacesOwnFilesAndKeepsOthers) {
  const fs::path place = root_ / "a";
  Fill(place, "old");
  Put(place / "notes.txt", "mine");
  fs::create_directories(place / "plots");
  Put(place / "plots" / "p.png", "also mine");
  Fill(place, "new");
  EXPECT_EQ(Content(place / "log.csv"), "new");
  EXPECT_EQ(Content(place / "notes.txt"), "mine");
  EXPECT_EQ(Content(place / "plots" / "p.png"), "also mine");
  EXPECT_THAT(Names(root_), ElementsAre("a"));
}

TEST_F(OutputFolderTest, KeepsOtherFilesIfReplacementFails) {
  const fs::path place = root_ / "a";
  Fill(place, "old");
  Put(place / "notes.txt", "mine");
  {
    OutputFolder folder(place, kKind);
    folder.Write("log.csv", "new");
    folder.Write("result.json", "{}");
    fs::remove(place / "log.csv");
    fs::create_directories(place / "log.csv" / "in the way");
    EXPECT_ANY_THROW(folder.Commit());
  }
  EXPECT_EQ(Content(place / "notes.txt"), "mine");
  EXPECT_TRUE(fs::is_directory(place / "log.csv" / "in the way"));
  EXPECT_THAT(Names(place), Not(Contains(StartsWith("."))));
}

TEST_F(OutputFolderTest, KeepsOldFolderWithoutCommit) {
  const fs::path place = root_ / "a";
  Fill(place, "old");
  { OutputFolder(place, kKind).Write("log.csv", "new"); }
  EXPECT_EQ(Content(place / "log.csv"), "old");
  EXPECT_THAT(Names(root_), ElementsAre("a"));
}

TEST_F(OutputFolderTest, RejectsFolderWithOtherFiles) {
  Put(root_ / "thesis.tex", "years of work");
  EXPECT_THROW(OutputFolder(root_, kKind), InputError);
  EXPECT_THAT(Names(root_), ElementsAre("thesis.tex"));
}

TEST_F(OutputFolderTest, RejectsFolderWithForeignFileOfSameName) {
  Put(root_ / "result.json", "{\"my own\": true}");
  EXPECT_THROW(OutputFolder(root_, kKind), InputError);
  EXPECT_EQ(Content(root_ / "result.json"), "{\"my own\": true}");
}

TEST_F(OutputFolderTest, AcceptsEmptyFolder) {
  fs::create_directories(root_ / "a");
  Fill(root_ / "a", "1");
  EXPECT_EQ(Content(root_ / "a" / "log.csv"), "1");
}

TEST_F(OutputFolderTest, AcceptsPathWithTrailingSlash) {
  Fill(root_ / "a" / "", "1");
  EXPECT_EQ(Content(root_ / "a" / "log.csv"), "1");
}

TEST_F(OutputFolderTest, FollowsLinkToFolder) {
  fs::create_directories(root_ / "disk");
  fs::create_directory_symlink(root_ / "disk", root_ / "link");
  Fill(root_ / "link" / "a", "1");
  EXPECT_EQ(Content(root_ / "disk" / "a" / "log.csv"), "1");
}

TEST_F(OutputFolderTest, RejectsPathThatCannotBeAFolder) {
  Put(root_ / "file", "1");
  EXPECT_THROW(OutputFolder(root_ / "file", kKind), InputError);
  EXPECT_THROW(OutputFolder(root_ / "file" / "a", kKind), InputError);
  EXPECT_THROW(OutputFolder("/proc/touchdown", kKind), InputError);
  EXPECT_THROW(OutputFolder("/", kKind), InputError);
  EXPECT_THROW(OutputFolder("", kKind), InputError);
  EXPECT_THROW(OutputFolder(fs::current_path(), kKind), InputError);
  EXPECT_THAT(Names(root_), ElementsAre("file"));
}

}  // namespace
}  // namespace touchdown::util
