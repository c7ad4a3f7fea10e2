// `touchdown report`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/program_fixture.h"
#include "tests/support/small_mount.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tests::ProgramRun;
using tests::SmallMount;

class ReportCommand : public tests::ProgramFixture {
 protected:
  void FlyInto(const std::string& place) const {
    folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.1\n");
    ASSERT_EQ(Run({"fly", "short.yaml", "--out", place}).status, 1);
  }
  /// Returns the error of a report of `place`. Expects that the folder does not change.
  std::string ErrorOfReport(const std::string& place) const {
    const std::string before = folder_.Content(place + "/report.html");
    const std::string error = ErrorOf({"report", place});
    EXPECT_EQ(folder_.Content(place + "/report.html"), before);
    if (fs::is_directory(folder_ / place)) {
      for (const auto& entry : fs::directory_iterator(folder_ / place)) {
        EXPECT_THAT(entry.path().filename().string(), Not(StartsWith(".")));
      }
    }
    return error;
  }
};

TEST_F(ReportCommand, RebuildsThePageOfTheFlight) {
  FlyInto("flight");
  const std::string page = folder_.Content("flight/report.html");
  EXPECT_THAT(page, HasSubstr("<title>short, seed 1: Failed</title>"));
  fs::remove(folder_ / "flight" / "report.html");
  const ProgramRun run = Run({"report", "flight"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "flight/report.html\n");
  EXPECT_EQ(folder_.Content("flight/report.html"), page);
  EXPECT_EQ(Run({"report", "flight/"}).status, 0);
}

TEST_F(ReportCommand, RejectsAFolderThatIsNotAFlightDirectory) {
  fs::create_directories(folder_ / "empty");
  folder_.Put("file", "");
  folder_.Put("other/result.json", "{}");
  for (const char* place : {"none", "empty", "file", "other"}) {
    EXPECT_THAT(ErrorOfReport(place), HasSubstr(std::string(place) + ": not a flight directory"));
  }
}

TEST_F(ReportCommand, NamesTheDamagedFile) {
  FlyInto("flight");
  fs::resize_file(folder_ / "flight" / "flight.csv", 2000);
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("flight/flight.csv:"));
  FlyInto("flight");
  fs::remove(folder_ / "flight" / "frames.csv");
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("flight/frames.csv: cannot be read"));
}

TEST_F(ReportCommand, KeepsAUsersPage) {
  FlyInto("flight");
  folder_.Put("flight/report.html", "<p>mine</p>");
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("already exists"));
}

TEST_F(ReportCommand, KeepsTheEarlierPageInAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_mounted()) GTEST_SKIP() << "no permission to mount";
  FlyInto("small/flight");
  small.Fill();
  EXPECT_THAT(ErrorOfReport("small/flight"), HasSubstr("report.html: cannot be written"));
  small.MakeReadOnly();
  EXPECT_THAT(ErrorOfReport("small/flight"), HasSubstr("report.html: cannot be written"));
}

}  // namespace
}  // namespace touchdown::cli
