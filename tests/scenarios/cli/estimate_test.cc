// `touchdown estimate`, and `score` on its poses, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
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
using ::testing::HasSubstr;
using tests::ProgramRun;
using tests::SmallMount;

class EstimateCommand : public tests::ProgramFixture {};

TEST_F(EstimateCommand, EstimatesOnARecordingAndScoresThePoses) {
  folder_.Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.5}]\n");
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

  const ProgramRun images =
      Run({"estimate", "a/recording/mav0/cam0/data", "--camera", "a/recording/camera.yaml", "--out", "c", "--quiet"});
  EXPECT_EQ(images.status, 0);
  EXPECT_EQ(images.out + images.err, "");
}

TEST_F(EstimateCommand, UsesACalibrationFile) {
  folder_.Put("miscalibrated.yaml", R"(start: {airborne: true}
script: [{do: hover, duration_s: 0.5}]
vehicle: {camera: {misalignment_deg: [3, 0, 0]}}
calibration: {camera: {misalignment_deg: [0, 0, 0]}}
)");
  ASSERT_EQ(Run({"fly", "miscalibrated.yaml", "--out", "a", "--record", "--video", "off"}).status, 0);
  folder_.Put("found.yaml", "camera: {misalignment_deg: [3, 0, 0]}\n");
  const auto roll_rmse_deg = [&](const std::vector<std::string>& calibration) {
    std::vector<std::string> arguments{"estimate", "a", "--out", "b", "--quiet"};
    arguments.insert(arguments.end(), calibration.begin(), calibration.end());
    EXPECT_EQ(Run(arguments).status, 0);
    const ProgramRun score = Run({"score", "--poses", "b/poses.tum", "--truth", "a", "--json"});
    return nlohmann::json::parse(score.out).at("metrics").at("estimate.roll_rmse_deg").get<double>();
  };
  EXPECT_NEAR(roll_rmse_deg({}), 3.0, 1.0);
  EXPECT_LT(roll_rmse_deg({"--calibration", "found.yaml"}), 1.5);
}

TEST_F(EstimateCommand, RejectsUnusableFootageAndWritesNothing) {
  fs::create_directories(folder_ / "empty");
  folder_.Put("camera.yaml", "width_px: 640\n");
  folder_.Put("bad.yaml", "width_px: wide\n");
  folder_.Put("video.mp4", "not a video");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"empty", "--camera", "camera.yaml"}, "empty: no images in this directory"},
      {{"none", "--camera", "camera.yaml"}, "none: no such file or directory"},
      {{"video.mp4", "--camera", "camera.yaml"}, "video.mp4: not a readable video"},
      {{"video.mp4", "--camera", "bad.yaml"}, "video.mp4: not a readable video"},
      {{"empty", "--camera", "camera.yaml", "--estimator", "magic"}, "empty: no images"},
  };
  const std::set<std::string> before = Names();
  for (const auto& [input, error] : cases) {
    std::vector<std::string> arguments{"estimate", "--out", "result"};
    arguments.insert(arguments.end(), input.begin(), input.end());
    EXPECT_THAT(ErrorOf(arguments), HasSubstr(error));
    EXPECT_EQ(Names(), before);
  }
}

TEST_F(EstimateCommand, KeepsEarlierPosesInAFullOrReadOnlyFolder) {
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_mounted()) GTEST_SKIP() << "no permission to mount";
  folder_.Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.2}]\n");
  ASSERT_EQ(Run({"fly", "short.yaml", "--out", "flight", "--record", "--video", "off"}).status, 0);
  ASSERT_EQ(Run({"estimate", "flight", "--out", "small/poses"}).status, 0);
  const std::string before = folder_.Content("small/poses/poses.csv");
  const auto expect_rejected = [&](const char* error) {
    EXPECT_THAT(ErrorOf({"estimate", "flight", "--out", "small/poses", "--quiet"}), HasSubstr(error));
    EXPECT_EQ(folder_.Content("small/poses/poses.csv"), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "small"), {}), 1) << "only the poses";
  };
  small.Fill();
  expect_rejected("cannot be written");
  small.MakeReadOnly();
  expect_rejected("Read-only file system");
}

}  // namespace
}  // namespace touchdown::cli
