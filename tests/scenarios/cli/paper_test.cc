// `touchdown paper`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program_fixture.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using tests::ProgramRun;

class PaperCommand : public tests::ProgramFixture {
 protected:
  std::vector<fs::path> Measured() const {
    std::vector<fs::path> files;
    const fs::path folder = folder_ / "paper" / "measurements";
    if (!fs::exists(folder)) return files;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    return files;
  }
  ProgramRun RunUntilMeasured(std::size_t count) const {
    return Run({"paper", "--quick", "--jobs", "2", "--out", "paper"},
               {SIGINT, [this, count] { return Measured().size() >= count; }});
  }
};

TEST_F(PaperCommand, KeepsItsMeasurementsWhenInterruptedAndResumes) {
  const ProgramRun first = RunUntilMeasured(1);
  EXPECT_EQ(first.status, 130);
  EXPECT_THAT(first.err, HasSubstr("interrupted: the measurements so far are kept in paper/measurements"));
  const std::vector<fs::path> kept = Measured();
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(Names(), std::set<std::string>{"paper"});
  EXPECT_FALSE(fs::exists(folder_ / "paper" / "report.html"));

  const auto written = fs::last_write_time(kept.front());
  const ProgramRun second = RunUntilMeasured(kept.size() + 1);
  EXPECT_EQ(second.status, 130);
  EXPECT_GT(Measured().size(), kept.size());
  EXPECT_EQ(fs::last_write_time(kept.front()), written);  // Not measured a second time.
  for (const fs::path& file : Measured()) {
    std::ifstream stream(file);
    EXPECT_TRUE(nlohmann::json::accept(stream)) << file;
  }
}

TEST_F(PaperCommand, RejectsAFolderWithOtherFiles) {
  folder_.Put("mine/thesis.tex", "years of work");
  EXPECT_THAT(ErrorOf({"paper", "--quick", "--out", "mine"}), HasSubstr("mine: contains other files"));
  EXPECT_EQ(folder_.Content("mine/thesis.tex"), "years of work");
  EXPECT_FALSE(fs::exists(folder_ / "mine" / "measurements"));
}

TEST_F(PaperCommand, DoesNotReplaceAFullRunByAQuickOne) {
  const std::string claim = R"({"kind": "touchdown.paper", "quick": false})";
  folder_.Put("full/paper.json", claim);
  folder_.Put("full/measurements/hovering_1.json", "an hour's work");
  EXPECT_THAT(ErrorOf({"paper", "--quick", "--out", "full"}), HasSubstr("full: contains a full run"));
  EXPECT_EQ(folder_.Content("full/paper.json"), claim);
  EXPECT_EQ(folder_.Content("full/measurements/hovering_1.json"), "an hour's work");
}

TEST_F(PaperCommand, RejectsBadUsage) {
  EXPECT_THAT(ErrorOf({"paper"}), HasSubstr("--out"));
  EXPECT_THAT(ErrorOf({"paper", "--out", "paper", "--jobs", "0"}), HasSubstr("--jobs"));
  EXPECT_TRUE(Names().empty());
}

}  // namespace
}  // namespace touchdown::cli
