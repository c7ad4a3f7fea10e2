// The program as a user meets it: exit status, what it says, and what it leaves behind.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/run_program.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;
using touchdown::tests::Interruption;
using touchdown::tests::ProgramRun;

constexpr const char* kGoodScript = "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\n";

class Program : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Put(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  ProgramRun Run(const std::vector<std::string>& arguments, const Interruption& interruption = {}) const {
    return touchdown::tests::RunProgram(TOUCHDOWN_PROGRAM, arguments, folder_, interruption);
  }
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    return names;
  }
  /// Flies `scenario`, expects exit 2, one line on stderr, and no folder; returns the line.
  std::string ErrorOfFlying(const std::string& scenario, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"fly", scenario, "--out", "result"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::vector<std::string> before = Names();
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(Names(), before);
    return run.err;
  }
  std::string ErrorOfText(const std::string& text, const std::vector<std::string>& more = {}) const {
    Put("bad.yaml", text);
    return ErrorOfFlying("bad.yaml", more);
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("program_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(Program, TellsItsVersionAndItsHelp) {
  const ProgramRun version = Run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, HasSubstr("0."));
  const ProgramRun help = Run({"fly", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("--set"), HasSubstr("--seed"), HasSubstr("--estimator"), HasSubstr("--video"),
                              HasSubstr("--out")));
}

TEST_F(Program, LeavesAFilmUnlessToldNotTo) {
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.1\n");
  const fs::path film = folder_ / "result" / "flight.mp4";
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result"}).status, 1);
  EXPECT_TRUE(fs::exists(film));
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result", "--video", "off"}).status, 1);
  EXPECT_FALSE(fs::exists(film));
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result", "--video", "on"}).status, 1);
  EXPECT_TRUE(fs::exists(film));
}

TEST_F(Program, LeavesNothingWhenTheDiskIsFull) {
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.2\n");
  const ProgramRun run = touchdown::tests::RunProgram(
      "/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 40; exec \"$0\" fly short.yaml --out a/result", TOUCHDOWN_PROGRAM},
      folder_);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, EndsWith("error: video flight.mp4: File too large\n"));
  EXPECT_THAT(Names(), UnorderedElementsAre("short.yaml"));
}

TEST_F(Program, DrawsThePadToPrintAndDescribesIt) {
  const ProgramRun run = Run({"pad", "--out", "print/pad.pdf"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(fs::exists(folder_ / "print" / "pad.pdf"));
  // Its own description makes the same pad, and stays as it is.
  const auto changed = fs::last_write_time(folder_ / "print" / "pad.yaml");
  EXPECT_EQ(Run({"pad", "--out", "print/pad.svg", "--pad", "print/pad.yaml"}).status, 0);
  EXPECT_EQ(fs::last_write_time(folder_ / "print" / "pad.yaml"), changed);
  EXPECT_EQ(Run({"pad", "--out", "print/pad.pdf"}).status, 0);
  // A flight takes it.
  Put("fly.yaml", std::string(kGoodScript) + "pad: print/pad.yaml\ntime_limit_s: 0.1\n");
  EXPECT_EQ(Run({"fly", "fly.yaml", "--out", "result"}).status, 1);
}

TEST_F(Program, DrawsFliesAndLooksForAPadWithMarks) {
  Put("mine.yaml", "marks: [{shape: bar, x_m: 0, y_m: 0.05, length_m: 0.02, width_m: 0.004, angle_deg: 30}]\n");
  ASSERT_EQ(Run({"pad", "--out", "pad.pdf", "--pad", "mine.yaml"}).status, 0);
  Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.1}]\npad: pad.yaml\n");
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "a", "--record", "--video", "off"}).status, 0);
  EXPECT_EQ(Run({"pad", "--out", "a/recording/pad.svg", "--pad", "mine.yaml"}).status, 0)
      << "its pad.yaml says the same";
  EXPECT_EQ(Run({"estimate", "a", "--pad", "pad.yaml", "--out", "b"}).status, 0);

  Put("mine.yaml", "marks:\n  - {shape: disc, x_m: 0, y_m: 0.05}\n");
  const ProgramRun refused = Run({"estimate", "a", "--pad", "mine.yaml", "--out", "c"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, EndsWith("mine.yaml:2: marks.0.diameter_m: must be given\n"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(Program, LeavesAPadsDescriptionThatWasEdited) {
  ASSERT_EQ(Run({"pad", "--out", "pad.pdf"}).status, 0);
  Put("pad.yaml", "ring_width_m: 0.012\n");
  const auto drawn = fs::last_write_time(folder_ / "pad.pdf");
  const ProgramRun run = Run({"pad", "--out", "pad.pdf"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("pad.yaml: is there already"));
  EXPECT_EQ(fs::file_size(folder_ / "pad.yaml"), std::string("ring_width_m: 0.012\n").size());
  EXPECT_EQ(fs::last_write_time(folder_ / "pad.pdf"), drawn);
  EXPECT_EQ(Run({"pad", "--out", "pad.pdf", "--pad", "pad.yaml"}).status, 0);
}

TEST_F(Program, LeavesAUsersFilesAndDrawsNoPadThatIsNone) {
  Put("mine.pdf", "a user's");
  Put("described.yaml", "a user's");
  Put("bad.yaml", "outer_radius_m: -1\n");
  const std::vector<std::string> before = Names();
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"pad", "--out", "mine.pdf"},
                                             {"pad", "--out", "described.pdf"},
                                             {"pad", "--out", "pad.png"},
                                             {"pad", "--out", "pad.pdf", "--pad", "bad.yaml"},
                                             {"pad", "--out", "pad.pdf", "--pad", "none.yaml"}}) {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_THAT(Names(), testing::UnorderedElementsAreArray(before));
}

/// A file system of its own in a folder, of 64 MiB at most until it is filled.
class SmallMount {
 public:
  explicit SmallMount(fs::path place) : place_(std::move(place)) {
    is_there_ = mount("none", place_.c_str(), "tmpfs", 0, "size=64m") == 0;
  }
  ~SmallMount() {
    if (is_there_) umount(place_.c_str());
  }
  SmallMount(const SmallMount&) = delete;
  SmallMount& operator=(const SmallMount&) = delete;

  bool is_there() const { return is_there_; }
  void Fill() const { Remount(MS_REMOUNT, fmt::format("size={}k", UsedKilobytes() + 16)); }
  void MakeReadOnly() const { Remount(MS_REMOUNT | MS_RDONLY, ""); }

 private:
  void Remount(unsigned long flags, const std::string& options) const {
    ASSERT_EQ(mount("none", place_.c_str(), "tmpfs", flags, options.c_str()), 0);
  }
  std::uintmax_t UsedKilobytes() const {
    const fs::space_info space = fs::space(place_);
    return (space.capacity - space.free) / 1024;
  }

  fs::path place_;
  bool is_there_ = false;
};

class ReportProgram : public Program {
 protected:
  void FlyInto(const std::string& place) const {
    Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.1\n");
    ASSERT_EQ(Run({"fly", "short.yaml", "--out", place}).status, 1);
  }
  std::string Content(const fs::path& file) const {
    std::ifstream stream(folder_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// Makes the report of `place`, expects exit 2, one line, and the folder as it was; returns the line.
  std::string ErrorOfReport(const std::string& place) const {
    const std::string before = Content(fs::path(place) / "report.html");
    const ProgramRun run = Run({"report", place});
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(Content(fs::path(place) / "report.html"), before);
    if (fs::is_directory(folder_ / place)) {
      for (const auto& entry : fs::directory_iterator(folder_ / place)) {
        EXPECT_THAT(entry.path().filename().string(), testing::Not(StartsWith(".")));
      }
    }
    return run.err;
  }
};

TEST_F(ReportProgram, RebuildsThePageThatTheFlightLeft) {
  FlyInto("flight");
  const std::string page = Content("flight/report.html");
  EXPECT_THAT(page, HasSubstr("<title>short, seed 1: Failed</title>"));
  fs::remove(folder_ / "flight" / "report.html");
  const ProgramRun run = Run({"report", "flight"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "flight/report.html\n");
  EXPECT_EQ(Content("flight/report.html"), page);
  EXPECT_EQ(Run({"report", "flight/"}).status, 0);
}

TEST_F(ReportProgram, RefusesWhatIsNoFlightsFolder) {
  fs::create_directories(folder_ / "empty");
  Put("file", "");
  fs::create_directories(folder_ / "other");
  std::ofstream(folder_ / "other" / "result.json") << "{}";
  for (const char* place : {"none", "empty", "file", "other"}) {
    EXPECT_THAT(ErrorOfReport(place), HasSubstr(std::string(place) + ": is no flight's folder"));
  }
}

TEST_F(ReportProgram, NamesTheFileLineAndColumnThatAreDamaged) {
  FlyInto("flight");
  fs::resize_file(folder_ / "flight" / "flight.csv", 2000);
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("flight/flight.csv:"));
  FlyInto("flight");
  fs::remove(folder_ / "flight" / "frames.csv");
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("flight/frames.csv: cannot be read"));
}

TEST_F(ReportProgram, LeavesAUsersPage) {
  FlyInto("flight");
  std::ofstream(folder_ / "flight" / "report.html") << "<p>mine</p>";
  EXPECT_THAT(ErrorOfReport("flight"), HasSubstr("is there already"));
}

TEST_F(ReportProgram, LeavesTheEarlierPageInAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_there()) GTEST_SKIP() << "no right to mount";
  FlyInto("small/flight");
  small.Fill();
  EXPECT_THAT(ErrorOfReport("small/flight"), HasSubstr("report.html: cannot be written"));
  small.MakeReadOnly();
  EXPECT_THAT(ErrorOfReport("small/flight"), HasSubstr("report.html: cannot be written"));
}

TEST_F(ReportProgram, LeavesNothingOfAFlightInAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_there()) GTEST_SKIP() << "no right to mount";
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.1\n");
  const auto error_of_flying = [&] {
    const ProgramRun run = Run({"fly", "short.yaml", "--out", "small/flight", "--quiet"});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(fs::is_empty(folder_ / "small"));
    return run.err;
  };
  small.Fill();
  EXPECT_THAT(error_of_flying(), HasSubstr("flight.mp4: No space left on device"));
  small.MakeReadOnly();
  EXPECT_THAT(error_of_flying(), HasSubstr("small/flight: Read-only file system"));
}

TEST_F(ReportProgram, LeavesEarlierPosesInAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_there()) GTEST_SKIP() << "no right to mount";
  Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.2}]\n");
  ASSERT_EQ(Run({"fly", "short.yaml", "--out", "flight", "--record", "--video", "off"}).status, 0);
  ASSERT_EQ(Run({"estimate", "flight", "--out", "small/poses"}).status, 0);
  const auto poses = [this] {
    std::ifstream stream(folder_ / "small" / "poses" / "poses.csv");
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string before = poses();
  const auto expect_refused = [&](const std::vector<std::string>& arguments, const char* error) {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(error));
    EXPECT_EQ(poses(), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "small"), {}), 1) << "the poses alone";
  };
  small.Fill();
  expect_refused({"estimate", "flight", "--out", "small/poses", "--quiet"}, "cannot be written");
  expect_refused({"fly", "short.yaml", "--out", "small/other", "--record", "--video", "off", "--quiet"},
                 "cannot be written");
  small.MakeReadOnly();
  expect_refused({"estimate", "flight", "--out", "small/poses", "--quiet"}, "Read-only file system");
}

TEST_F(Program, ExitsWithTwoOnBadUsage) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"flie"},
                                             {"fly"},
                                             {"fly", "a.yaml", "--sed", "1"},
                                             {"fly", "a.yaml", "--estimator"},
                                             {"fly", "a.yaml", "--video", "maybe"},
                                             {"fly", "a.yaml", "b.yaml"}}) {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_THAT(run.err, StartsWith("error: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_TRUE(Names().empty());
}

TEST_F(Program, RefusesAnUnknownKey) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "camera:\n  fps: 60\n"),
              HasSubstr("bad.yaml:5: camera.fps: unknown key"));
}

TEST_F(Program, RefusesADuplicateKey) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "seed: 1\nseed: 2\n"),
              HasSubstr("bad.yaml:5: seed: duplicate key"));
}

TEST_F(Program, RefusesAWrongType) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "seed: [1]\n"),
              HasSubstr("bad.yaml:4: seed: must be a whole number"));
}

TEST_F(Program, RefusesWhatIsNotANumber) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "camera: {noise_sigma: .nan}\n"),
              HasSubstr("bad.yaml:4: camera.noise_sigma: must be a finite number"));
}

TEST_F(Program, RefusesANegativeMass) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "vehicle: {mass_kg: -1}\n"),
              HasSubstr("bad.yaml:4: vehicle.mass_kg: must be above 0"));
}

TEST_F(Program, RefusesAnImageOfNoSize) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "camera: {model: {height_px: 0}}\n"),
              HasSubstr("bad.yaml:4: camera.model.height_px: must be from 1 to 16384, is 0"));
}

TEST_F(Program, RefusesAMissingFile) {
  EXPECT_THAT(ErrorOfFlying("none.yaml"), HasSubstr("none.yaml: no such file"));
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "pad: none.yaml\n"),
              AllOf(HasSubstr("bad.yaml:4: pad: "), HasSubstr("none.yaml: no such file")));
}

TEST_F(Program, RefusesAnEmptyFile) { EXPECT_THAT(ErrorOfText(""), HasSubstr("bad.yaml:1: is empty")); }

TEST_F(Program, RefusesAHundredThousandBrackets) {
  const std::string open(100000, '['), close(100000, ']');
  EXPECT_THAT(ErrorOfText("script: " + open), HasSubstr("bad.yaml:1: "));
  EXPECT_THAT(ErrorOfText("script: " + open + close), HasSubstr("bad.yaml:1: nested"));
}

TEST_F(Program, RefusesAFolderForAScenario) {
  fs::create_directories(folder_ / "folder.yaml");
  EXPECT_THAT(ErrorOfFlying("folder.yaml"), HasSubstr("folder.yaml: is a folder"));
}

TEST_F(Program, RefusesAnUnknownEstimator) {
  EXPECT_THAT(ErrorOfText(std::string(kGoodScript) + "estimator: {name: magic}\n"),
              HasSubstr("bad.yaml:4: estimator.name: unknown estimator 'magic', known: paper"));
}

TEST_F(Program, NamesTheOptionThatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--estimator", "magic"}, {"--estimator", ""}, {"--seed", "one"}, {"--seed", "18446744073709551616"}};
  for (const auto& [option, value] : wrong) {
    EXPECT_THAT(
        ErrorOfText(kGoodScript, {option, value}),
        StartsWith("error: " + option + " " + value + ": " + (option == "--seed" ? "seed: " : "estimator.name: ")));
  }
}

TEST_F(Program, RefusesToSetAKeyThatDoesNotExist) {
  EXPECT_THAT(ErrorOfText(kGoodScript, {"--set", "camera.fps=60"}),
              HasSubstr("--set camera.fps=60: camera.fps: unknown key"));
}

TEST_F(Program, RefusesAnOutputFolderThatHoldsOtherThings) {
  fs::create_directories(folder_ / "result");
  std::ofstream(folder_ / "result" / "thesis.tex") << "years of work";
  EXPECT_THAT(ErrorOfText(kGoodScript), HasSubstr("holds other files"));
  EXPECT_TRUE(fs::exists(folder_ / "result" / "thesis.tex"));
}

TEST_F(Program, RefusesAnOutputFolderThatCannotBeWritten) {
  Put("good.yaml", kGoodScript);
  Put("file", "");
  for (const char* place : {"", "file", "file/below", "/proc/touchdown"}) {
    const ProgramRun run = Run({"fly", "good.yaml", "--out", place});
    EXPECT_EQ(run.status, 2) << place;
    EXPECT_THAT(run.err, HasSubstr("output folder"));
  }
  EXPECT_THAT(Names(), UnorderedElementsAre("good.yaml", "file"));
}

TEST_F(Program, RefusesToWriteOverTheScenarioItFlies) {
  fs::create_directories(folder_ / "result");
  std::ofstream(folder_ / "result" / "scenario.yaml") << kGoodScript;
  std::ofstream(folder_ / "result" / "result.json") << "{\"log_sha256\": \"\"}";
  const ProgramRun run = Run({"fly", "result/scenario.yaml", "--out", "result"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("holds the scenario that is flown"));
}

TEST_F(Program, LeavesNothingWhenInterrupted) {
  Put("good.yaml", kGoodScript);
  const auto flies = [this] { return fs::exists(folder_ / "a"); };
  for (const int signal : {SIGINT, SIGHUP}) {
    const ProgramRun run = Run({"fly", "good.yaml", "--out", "a/result"}, {signal, flies});
    EXPECT_EQ(run.status, 130) << signal;
    EXPECT_THAT(Names(), UnorderedElementsAre("good.yaml"));
  }
}

TEST_F(Program, SaysNothingOrOnlyJsonWhenAsked) {
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.1\nexpect: gave_up\n");
  const ProgramRun quiet = Run({"fly", "short.yaml", "--out", "a", "--quiet", "--video", "off"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const ProgramRun json = Run({"fly", "short.yaml", "--out", "b", "--json", "--video", "off"});
  EXPECT_EQ(json.err, "");
  std::ifstream result(folder_ / "b" / "result.json");
  EXPECT_EQ(json.out, std::string(std::istreambuf_iterator<char>(result), {}));
  EXPECT_THAT(json.out, HasSubstr("\"reason\": \""));
}

TEST_F(Program, WritesChecksAsJUnitAndSparesOtherFiles) {
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.1\n");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(Run({"fly", "short.yaml", "--out", "a", "--junit", "ci/junit.xml", "--video", "off"}).status, 1);
  }
  std::ifstream junit(folder_ / "ci" / "junit.xml");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(junit), {}), HasSubstr("failures=\"1\""));
  Put("mine.xml", "<mine/>");
  const ProgramRun refused = Run({"fly", "short.yaml", "--out", "c", "--junit", "mine.xml"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("mine.xml: is there already, and something else"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(Program, EstimatesOnARecordingAndScoresIts) {
  Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.5}]\n");
  ASSERT_EQ(Run({"fly", "short.yaml", "--out", "a", "--record"}).status, 0);
  const ProgramRun run = Run({"estimate", "a", "--out", "b", "--video"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("  ok "), HasSubstr("X_WB; files in b\n")));
  for (const char* name : {"poses.csv", "poses.tum", "choices.csv", "summary.json", "estimate.mp4"}) {
    EXPECT_TRUE(fs::exists(folder_ / "b" / name)) << name;
  }
  const ProgramRun score = Run({"score", "--poses", "b/poses.tum", "--truth", "a"});
  EXPECT_EQ(score.status, 0) << score.err;
  EXPECT_THAT(score.out, HasSubstr("estimate.xy_rmse_m"));

  const ProgramRun pictures =
      Run({"estimate", "a/recording/mav0/cam0/data", "--camera", "a/recording/camera.yaml", "--out", "c", "--quiet"});
  EXPECT_EQ(pictures.status, 0);
  EXPECT_EQ(pictures.out + pictures.err, "");
}

TEST_F(Program, RefusesFootageThatItCannotUseAndLeavesWhatWasThere) {
  fs::create_directories(folder_ / "empty");
  Put("camera.yaml", "width_px: 640\n");
  Put("bad.yaml", "width_px: wide\n");
  Put("film.mp4", "no film");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"empty", "--camera", "camera.yaml"}, "empty: no pictures in this folder"},
      {{"none", "--camera", "camera.yaml"}, "none: no such file or folder"},
      {{"film.mp4", "--camera", "camera.yaml"}, "film.mp4: no video that can be read"},
      {{"film.mp4", "--camera", "bad.yaml"}, "film.mp4: no video that can be read"},
      {{"empty", "--camera", "camera.yaml", "--estimator", "magic"}, "empty: no pictures"},
  };
  const std::vector<std::string> before = Names();
  for (const auto& [input, error] : cases) {
    std::vector<std::string> arguments{"estimate", "--out", "result"};
    arguments.insert(arguments.end(), input.begin(), input.end());
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2) << input[0];
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(error));
    EXPECT_EQ(Names(), before);
  }
}

TEST_F(Program, ExitsWithThreeWhenItsOutputCannotBeWritten) {
  Put("short.yaml", std::string(kGoodScript) + "time_limit_s: 0.01\n");
  const ProgramRun run = touchdown::tests::RunProgram(
      "/bin/sh", {"-c", "exec \"$0\" fly short.yaml --out result > /dev/full", TOUCHDOWN_PROGRAM}, folder_);
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "error: internal error: the standard output cannot be written\n");
}

TEST_F(Program, ExitsWithThreeWhenTheSimulationGoesWrong) {
  // Drag that no step of the clock is short enough for.
  Put("stiff.yaml",
      "start: {airborne: true}\nscript: [{do: hover, duration_s: 1}]\n"
      "vehicle: {linear_drag_n_s_m: [1e9, 1e9, 1e9]}\nworld: {wind_m_s: [50, 0, 0]}\n");
  const ProgramRun run = Run({"fly", "stiff.yaml", "--out", "result"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, StartsWith("error: the simulation went wrong: MuJoCo: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("): error\n"));
  EXPECT_TRUE(fs::exists(folder_ / "result" / "result.json"));
  EXPECT_FALSE(fs::exists(folder_ / "result" / "frames.png")) << "the flight had no frames";
}

}  // namespace
}  // namespace touchdown::scenarios
