// Complete flights of the scenarios of the project.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "scenarios/cli/flight_folder.h"
#include "scenarios/runner/fly.h"
#include "scenarios/runner/scenario.h"
#include "tests/support/docs_image.h"

namespace touchdown::runner {
namespace {

namespace fs = std::filesystem;

Scenario Flight(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return LoadScenario(fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / (name + ".yaml"),
                      std::vector<Override>(overrides.begin(), overrides.end()));
}

void ExpectPass(const FlightResult& result) {
  EXPECT_EQ(result.verdict, Verdict::kPass) << result.reason;
  for (const Check& check : result.checks) {
    EXPECT_TRUE(check.pass) << check.name << " is " << (check.value ? std::to_string(*check.value) : check.text)
                            << ", limit " << check.limit;
  }
}

/// Overrides that end a flight in the air.
std::vector<std::string> Short() { return {"time_limit_s=3"}; }

cv::Mat VideoFrameAt(const fs::path& file, double time_s) {
  cv::VideoCapture video(file.string());
  video.set(cv::CAP_PROP_POS_MSEC, 1000.0 * time_s);
  cv::Mat frame;
  video.read(frame);
  return frame;
}

/// Tolerance of the images. JPEG compression causes a difference of 2, a shift by one frame 5 or more. Flights on other
/// types of CPU look the same.
constexpr double kMaxDifference = 8.0;

/// The README shows the downsized contact sheet of this flight, the tour a frame of its video. To update the images:
///   TOUCHDOWN_WRITE_DOCS=1 build/release/tests/scenarios/shipped_flights_slow_tests --gtest_filter=*README*
TEST(Flights, TakeoffHoverLandPassesAndMatchesTheImagesOfTheREADME) {
  const fs::path place = fs::path(::testing::TempDir()) / "flights_test_takeoff_hover_land";
  fs::remove_all(place);
  ExpectPass(cli::FlyIntoFolder(Flight("takeoff_hover_land"), place));
  cv::Mat sheet;
  cv::VideoCapture video((place / "flight.mp4").string());
  EXPECT_GT(video.get(cv::CAP_PROP_FRAME_COUNT), 400);
  EXPECT_LE(static_cast<double>(fs::file_size(place / "flight.mp4")), 1e5 / 30.0 * video.get(cv::CAP_PROP_FRAME_COUNT))
      << "at most 1 MB for 10 s";
  cv::resize(cv::imread((place / "frames.png").string()), sheet, {1280, 720}, 0, 0, cv::INTER_AREA);
  const cv::Mat frame = VideoFrameAt(place / "flight.mp4", 7.0);
  fs::remove_all(place);
  tests::ExpectDocsImage("takeoff_hover_land.jpg", sheet, kMaxDifference);
  tests::ExpectDocsImage("video.jpg", frame, kMaxDifference);
}

TEST(Flights, GiveUpWhenThePadIsCovered) {
  const FlightResult result =
      Fly(Flight("landing", {"events=[{at_s: 1.0, do: cover_pad, duration_s: 100}]", "expect=gave_up", "criteria=[]"}));
  EXPECT_EQ(result.outcome, Outcome::kGaveUp);
  EXPECT_EQ(result.verdict, Verdict::kPass);
  EXPECT_FALSE(result.metrics.contains("flight.touchdown_xy_error_m"));
  EXPECT_EQ(result.metrics.at("estimate.false_pads"), 0.0);
}

TEST(Flights, PassWithAShortLossOfFrames) {
  ExpectPass(Fly(Flight("takeoff_hover_land", {"events=[{at_s: 8, do: lose_frames, duration_s: 0.4}]"})));
}

TEST(Flights, HaveTheSameLogForTheSameSeedAlsoWithAConcurrentFlight) {
  const Scenario scenario = Flight("takeoff_hover_land");
  const FlightResult alone = Fly(scenario);
  // disturbed_hover, shortened to the duration of this flight.
  auto other = std::async(std::launch::async, [] {
    return Fly(Flight("disturbed_hover", {"script.1.duration_s=10", "time_limit_s=20", "criteria=[]",
                                          "events=[{at_s: 7, do: push, force_n: [2.6, 0, 0], duration_s: 0.5}]"}));
  });
  const FlightResult concurrent = Fly(scenario);
  EXPECT_EQ(other.get().verdict, Verdict::kPass);
  EXPECT_EQ(alone.verdict, Verdict::kPass);
  EXPECT_EQ(alone.log_sha256, concurrent.log_sha256);
}

TEST(Flights, HaveAnotherLogForAnotherSeed) {
  EXPECT_NE(Fly(Flight("takeoff_hover_land", Short())).log_sha256,
            Fly(Flight("takeoff_hover_land", {"time_limit_s=3", "seed=2"})).log_sha256);
}

TEST(Flights, HaveTheSameLogFromTheResolvedScenario) {
  const Scenario scenario = Flight("landing", Short());
  EXPECT_EQ(Fly(scenario).log_sha256, Fly(ParseScenario(ScenarioYaml(scenario), "f", "")).log_sha256);
}

TEST(Flights, WriteAllFiles) {
  const fs::path place = fs::path(::testing::TempDir()) / "flights_test_folder";
  fs::remove_all(place);
  const FlightResult result = cli::FlyIntoFolder(Flight("landing", Short()), place);
  EXPECT_EQ(result.verdict, Verdict::kFail);
  for (const char* name :
       {"scenario.yaml", "result.json", "flight.csv", "frames.csv", "tracking.csv", "truth.tum", "estimate.tum",
        "tracking.tum", "frame_timing.csv", "timing.json", "frames.png", "flight.mp4"}) {
    EXPECT_GT(fs::file_size(place / name), 0u) << name;
  }
  std::ifstream stream(place / "result.json");
  const nlohmann::json json = nlohmann::json::parse(stream);
  EXPECT_EQ(json.at("outcome"), "gave_up");
  EXPECT_EQ(json.at("verdict"), "fail");
  EXPECT_EQ(json.at("log_sha256"), result.log_sha256);
  cv::VideoCapture video((place / "flight.mp4").string());
  EXPECT_EQ(video.get(cv::CAP_PROP_FPS), 30.0);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), 91) << "3 s and the last image";
  fs::remove_all(place);
}

TEST(Flights, HaveTheSameLogWithAndWithoutVideo) {
  const fs::path place = fs::path(::testing::TempDir()) / "flights_test_video";
  fs::remove_all(place);
  const Scenario scenario = Flight("landing", {"time_limit_s=2",
                                               "events=[{at_s: 0.5, do: cover_pad, duration_s: 0.5}, "
                                               "{at_s: 1.2, do: lose_frames, duration_s: 0.2}]"});
  const FlightResult without = cli::FlyIntoFolder(scenario, place, {.video = false});
  EXPECT_FALSE(fs::exists(place / "flight.mp4"));
  const FlightResult with = cli::FlyIntoFolder(scenario, place, {.video = true});
  EXPECT_TRUE(fs::exists(place / "flight.mp4"));
  EXPECT_EQ(with.log_sha256, without.log_sha256);
  // The video of an earlier flight is removed.
  cli::FlyIntoFolder(scenario, place, {.video = false});
  EXPECT_FALSE(fs::exists(place / "flight.mp4"));
  fs::remove_all(place);
}

}  // namespace
}  // namespace touchdown::runner
