// `touchdown fly`, run as a program: its errors, its output and its files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/program_fixture.h"
#include "tests/support/small_mount.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;
using tests::ProgramRun;
using tests::SmallMount;

class FlyCommand : public tests::ProgramFixture {
 protected:
  /// Returns the error message. Expects that the program writes no file.
  std::string ErrorOfFlying(const std::string& scenario, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"fly", scenario, "--out", "result"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::set<std::string> before = Names();
    const std::string error = ErrorOf(arguments);
    EXPECT_EQ(Names(), before);
    return error;
  }
  std::string ErrorOfText(const std::string& text, const std::vector<std::string>& more = {}) const {
    folder_.Put("bad.yaml", text);
    return ErrorOfFlying("bad.yaml", more);
  }
};

TEST_F(FlyCommand, RejectsAnUnknownKey) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "camera:\n  fps: 60\n"),
              HasSubstr("bad.yaml:5: camera.fps: unknown key"));
}

TEST_F(FlyCommand, RejectsADuplicateKey) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "seed: 1\nseed: 2\n"), HasSubstr("bad.yaml:5: seed: duplicate key"));
}

TEST_F(FlyCommand, RejectsAWrongType) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "seed: [1]\n"), HasSubstr("bad.yaml:4: seed: must be an integer"));
}

TEST_F(FlyCommand, RejectsANonFiniteNumber) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "camera: {noise_sigma: .nan}\n"),
              HasSubstr("bad.yaml:4: camera.noise_sigma: must be a finite number"));
}

TEST_F(FlyCommand, RejectsANegativeMass) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "vehicle: {mass_kg: -1}\n"),
              HasSubstr("bad.yaml:4: vehicle.mass_kg: must be above 0"));
}

TEST_F(FlyCommand, RejectsAnImageOfZeroSize) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "camera: {model: {height_px: 0}}\n"),
              HasSubstr("bad.yaml:4: camera.model.height_px: must be from 1 to 16384, is 0"));
}

TEST_F(FlyCommand, RejectsAMissingFile) {
  EXPECT_THAT(ErrorOfFlying("none.yaml"), HasSubstr("none.yaml: no such file"));
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "pad: none.yaml\n"),
              AllOf(HasSubstr("bad.yaml:4: pad: "), HasSubstr("none.yaml: no such file")));
}

TEST_F(FlyCommand, RejectsAnEmptyFile) { EXPECT_THAT(ErrorOfText(""), HasSubstr("bad.yaml:1: is empty")); }

TEST_F(FlyCommand, RejectsAHundredThousandBrackets) {
  const std::string open(100000, '['), close(100000, ']');
  EXPECT_THAT(ErrorOfText("script: " + open), HasSubstr("bad.yaml:1: "));
  EXPECT_THAT(ErrorOfText("script: " + open + close), HasSubstr("bad.yaml:1: nested"));
}

TEST_F(FlyCommand, RejectsAFolderAsScenario) {
  fs::create_directories(folder_ / "folder.yaml");
  EXPECT_THAT(ErrorOfFlying("folder.yaml"), HasSubstr("folder.yaml: is a folder"));
}

TEST_F(FlyCommand, RejectsAnUnknownEstimator) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding + "estimator: {name: magic}\n"),
              HasSubstr("bad.yaml:4: estimator.name: unknown estimator 'magic'; allowed: paper"));
}

TEST_F(FlyCommand, NamesTheInvalidOption) {
  const std::vector<std::pair<std::string, std::string>> invalid = {
      {"--estimator", "magic"}, {"--estimator", ""}, {"--seed", "one"}, {"--seed", "18446744073709551616"}};
  for (const auto& [option, value] : invalid) {
    EXPECT_THAT(
        ErrorOfText(kTakeoffAndLanding, {option, value}),
        StartsWith("error: " + option + " " + value + ": " + (option == "--seed" ? "seed: " : "estimator.name: ")));
  }
}

TEST_F(FlyCommand, RejectsAnOverrideOfAnUnknownKey) {
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding, {"--set", "camera.fps=60"}),
              HasSubstr("--set camera.fps=60: camera.fps: unknown key"));
}

TEST_F(FlyCommand, RejectsAnOutputFolderWithOtherFiles) {
  folder_.Put("result/thesis.tex", "years of work");
  EXPECT_THAT(ErrorOfText(kTakeoffAndLanding), HasSubstr("contains other files"));
  EXPECT_TRUE(fs::exists(folder_ / "result" / "thesis.tex"));
}

TEST_F(FlyCommand, RejectsAnUnwritableOutputFolder) {
  folder_.Put("good.yaml", kTakeoffAndLanding);
  folder_.Put("file", "");
  for (const char* place : {"", "file", "file/below", "/proc/touchdown"}) {
    EXPECT_THAT(ErrorOf({"fly", "good.yaml", "--out", place}), HasSubstr("output folder")) << place;
  }
  EXPECT_THAT(Names(), UnorderedElementsAre("good.yaml", "file"));
}

TEST_F(FlyCommand, RejectsTheFolderOfTheScenarioAsOutput) {
  folder_.Put("result/scenario.yaml", kTakeoffAndLanding);
  folder_.Put("result/result.json", "{\"log_sha256\": \"\"}");
  EXPECT_THAT(ErrorOfFlying("result/scenario.yaml"), HasSubstr("contains the scenario to fly"));
}

TEST_F(FlyCommand, WritesNothingWhenInterrupted) {
  folder_.Put("good.yaml", kTakeoffAndLanding);
  const auto flies = [this] { return fs::exists(folder_ / "a"); };
  for (const int signal : {SIGINT, SIGHUP}) {
    const ProgramRun run = Run({"fly", "good.yaml", "--out", "a/result"}, {signal, flies});
    EXPECT_EQ(run.status, 130) << signal;
    EXPECT_THAT(Names(), UnorderedElementsAre("good.yaml"));
  }
}

TEST_F(FlyCommand, WritesNothingWhenTheDiskIsFull) {
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.2\n");
  const ProgramRun run = tests::RunProgram(
      "/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 40; exec \"$0\" fly short.yaml --out a/result", TOUCHDOWN_PROGRAM},
      folder_.path());
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, EndsWith("error: video flight.mp4: File too large\n"));
  EXPECT_THAT(Names(), UnorderedElementsAre("short.yaml"));
}

TEST_F(FlyCommand, WritesNothingToAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_mounted()) GTEST_SKIP() << "no permission to mount";
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.1\n");
  const auto expect_rejected = [&](const std::vector<std::string>& options, const char* error) {
    std::vector<std::string> arguments = {"fly", "short.yaml", "--out", "small/flight", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_THAT(ErrorOf(arguments), HasSubstr(error));
    EXPECT_TRUE(fs::is_empty(folder_ / "small"));
  };
  small.Fill();
  expect_rejected({}, "flight.mp4: No space left on device");
  expect_rejected({"--record", "--video", "off"}, "cannot be written");
  small.MakeReadOnly();
  expect_rejected({}, "small/flight: Read-only file system");
}

TEST_F(FlyCommand, WritesAVideoUnlessItIsOff) {
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.1\n");
  const fs::path video = folder_ / "result" / "flight.mp4";
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result"}).status, 1);
  EXPECT_TRUE(fs::exists(video));
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result", "--video", "off"}).status, 1);
  EXPECT_FALSE(fs::exists(video));
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "result", "--video", "on"}).status, 1);
  EXPECT_TRUE(fs::exists(video));
}

TEST_F(FlyCommand, PrintsNothingOrOnlyJson) {
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.1\nexpect: gave_up\n");
  const ProgramRun quiet = Run({"fly", "short.yaml", "--out", "a", "--quiet", "--video", "off"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const ProgramRun json = Run({"fly", "short.yaml", "--out", "b", "--json", "--video", "off"});
  EXPECT_EQ(json.err, "");
  EXPECT_EQ(json.out, folder_.Content("b/result.json"));
  EXPECT_THAT(json.out, HasSubstr("\"reason\": \""));
}

TEST_F(FlyCommand, WritesChecksAsJUnitAndKeepsOtherFiles) {
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.1\n");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(Run({"fly", "short.yaml", "--out", "a", "--junit", "ci/junit.xml", "--video", "off"}).status, 1);
  }
  EXPECT_THAT(folder_.Content("ci/junit.xml"), HasSubstr("failures=\"1\""));
  folder_.Put("mine.xml", "<mine/>");
  EXPECT_THAT(ErrorOf({"fly", "short.yaml", "--out", "c", "--junit", "mine.xml"}),
              HasSubstr("mine.xml: already exists and is not an earlier output"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(FlyCommand, ExitsWithThreeWhenTheSimulationFails) {
  // Drag so large that the integration diverges at the simulation's time step.
  folder_.Put("stiff.yaml",
              "start: {airborne: true}\nscript: [{do: hover, duration_s: 1}]\n"
              "vehicle: {linear_drag_n_s_m: [1e9, 1e9, 1e9]}\nworld: {wind_m_s: [50, 0, 0]}\n");
  const ProgramRun run = Run({"fly", "stiff.yaml", "--out", "result"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, StartsWith("error: the simulation failed: MuJoCo: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("): error\n"));
  EXPECT_TRUE(fs::exists(folder_ / "result" / "result.json"));
  EXPECT_FALSE(fs::exists(folder_ / "result" / "frames.png")) << "the flight had no frames";
}

}  // namespace
}  // namespace touchdown::cli
