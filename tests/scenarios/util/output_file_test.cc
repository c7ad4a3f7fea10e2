#include "scenarios/util/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "models/error.h"

namespace touchdown::util {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string Content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static int Files(const fs::path& folder) {
    return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("output_file_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(OutputFile, IsWrittenWithParentFolders) {
  WriteOutputFile(folder_ / "a" / "b.txt", "mark 1", "mark");
  EXPECT_EQ(Content(folder_ / "a" / "b.txt"), "mark 1");
  EXPECT_EQ(Files(folder_ / "a"), 1);
}

TEST_F(OutputFile, ReplacesFileWithSameSignature) {
  WriteOutputFile(folder_ / "b.txt", "mark 1", "mark");
  WriteOutputFile(folder_ / "b.txt", "mark 2", "mark");
  EXPECT_EQ(Content(folder_ / "b.txt"), "mark 2");
  EXPECT_EQ(Files(folder_), 1);
}

TEST_F(OutputFile, KeepsFileWithoutSignature) {
  std::ofstream(folder_ / "b.txt") << "a user's";
  fs::create_directories(folder_ / "folder.txt");
  for (const char* name : {"b.txt", "folder.txt"}) {
    EXPECT_THROW(CheckOutputFile(folder_ / name, "mark"), InputError);
    EXPECT_THROW(WriteOutputFile(folder_ / name, "mark 1", "mark"), InputError);
  }
  EXPECT_EQ(Content(folder_ / "b.txt"), "a user's");
  EXPECT_EQ(Files(folder_), 2);
}

TEST_F(OutputFile, RejectsInvalidPath) {
  std::ofstream(folder_ / "file") << "a user's";
  EXPECT_THROW(WriteOutputFile(folder_ / "file" / "b.txt", "mark", "mark"), InputError);
  EXPECT_THROW(WriteOutputFile(folder_ / "", "mark", "mark"), InputError);
  EXPECT_THROW(WriteOutputFile("/dev/full", "mark", "mark"), InputError);
  EXPECT_EQ(Files(folder_), 1);
}

TEST_F(OutputFile, MustContainItsSignature) {
  EXPECT_THROW(WriteOutputFile(folder_ / "b.txt", "1", "mark"), std::logic_error);
}

}  // namespace
}  // namespace touchdown::util
