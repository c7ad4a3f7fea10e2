// The program as a user meets it: exit status, what it says, and what it leaves behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
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
