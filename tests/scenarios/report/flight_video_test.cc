#include "scenarios/report/flight_video.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "tests/support/worlds.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

constexpr int kVideoHeight_px = 512;  ///< With the caption below the two views.
constexpr int kViewHeight_px = 480;

class FlightVideoTest : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }

  void Start(int camera_hz = 60, int width_px = 640, int height_px = 480) {
    scenario_.camera.rate_hz = camera_hz;
    scenario_.camera.model.width_px = width_px;
    scenario_.camera.model.height_px = height_px;
    world_ = std::make_unique<sim::World>(tests::Unpainted(), scenario_.vehicle, tests::EmptyRoom(), scenario_.time, 1);
    video_ = std::make_unique<FlightVideo>(scenario_, file_);
    video_->OnStart(*world_);
  }
  models::Tick CameraPeriod() const { return scenario_.time.PeriodOf(scenario_.camera.rate_hz); }
  /// Passes frame `number`, of uniform gray, to the video. The height of the vehicle grows with time.
  void Show(int number, std::uint8_t gray, bool pad_is_covered = false) {
    const models::CameraModel& model = scenario_.camera.model;
    models::CameraFrame frame;
    frame.mid_exposure = number * CameraPeriod();
    frame.image = models::Image(model.width_px, model.height_px, gray);
    runner::FrameRecord record;
    record.mid_exposure = frame.mid_exposure;
    record.X_WB.translation() << 0.0, 0.0, 0.2 + 0.2 * scenario_.time.ToSeconds(frame.mid_exposure);
    record.pad_is_covered = pad_is_covered;
    video_->OnImu({.tick = frame.mid_exposure}, false);
    video_->OnFrame(frame, {}, record);
  }
  void ContinueUntil(double until_s) { video_->OnImu({.tick = scenario_.time.FromSeconds(until_s)}, false); }

  cv::VideoCapture OpenVideo() const { return cv::VideoCapture(file_.string()); }
  std::vector<cv::Mat3b> VideoFrames() const {
    cv::VideoCapture video = OpenVideo();
    std::vector<cv::Mat3b> frames;
    for (cv::Mat frame; video.read(frame);) frames.push_back(frame.clone());
    return frames;
  }
  static int OnboardGray(const cv::Mat3b& frame) { return frame(100, 100)[1]; }

  runner::Scenario scenario_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<FlightVideo> video_;
  const fs::path file_ =
      fs::path(::testing::TempDir()) /
      ("flight_video_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".mp4");
};

TEST_F(FlightVideoTest, ShowsOnboardAndChaseViewInFlightTime) {
  Start();
  for (int i = 0; i < 60; ++i) Show(i, static_cast<std::uint8_t>(60 + 2 * i));
  ContinueUntil(0.999);
  video_->Finish();
  EXPECT_EQ(OpenVideo().get(cv::CAP_PROP_FPS), 30.0);
  const std::vector<cv::Mat3b> frames = VideoFrames();
  ASSERT_EQ(frames.size(), 30u);
  for (int k = 0; k < 30; ++k) {
    const cv::Mat3b& frame = frames[static_cast<std::size_t>(k)];
    ASSERT_EQ(frame.size(), cv::Size(640 + kViewHeight_px, kVideoHeight_px));
    EXPECT_NEAR(OnboardGray(frame), 60 + 4 * k, 3.0) << "video frame k shows camera frame 2k";
  }
  // The vehicle rises in the right view, and the caption changes.
  const cv::Rect right(640, 0, kViewHeight_px, kViewHeight_px),
      caption(0, kViewHeight_px, 640, kVideoHeight_px - kViewHeight_px);
  EXPECT_GT(cv::norm(frames.front()(right), frames.back()(right), cv::NORM_L1), 5e5);
  EXPECT_GT(cv::norm(frames.front()(caption), frames.back()(caption), cv::NORM_L1), 1e4);
}

TEST_F(FlightVideoTest, RepeatsLastFrameWhileFramesAreMissingAndUntilEndOfFlight) {
  Start();
  for (int i = 0; i < 120; ++i) {
    if (i < 30 || (i > 60 && i < 90)) Show(i, static_cast<std::uint8_t>(60 + i));
  }
  ContinueUntil(3.01);
  video_->Finish();
  const std::vector<cv::Mat3b> frames = VideoFrames();
  ASSERT_EQ(frames.size(), 91u);
  for (const auto& [k, frame] : {std::pair(0, 0), std::pair(14, 28), std::pair(15, 28), std::pair(30, 28),
                                 std::pair(31, 62), std::pair(44, 88), std::pair(45, 88), std::pair(90, 88)}) {
    EXPECT_NEAR(OnboardGray(frames[static_cast<std::size_t>(k)]), 60 + frame, 3.0) << k;
  }
}

TEST_F(FlightVideoTest, DividesCameraRateByInteger) {
  for (const auto& [camera_hz, fps] : {std::pair(30, 30.0), std::pair(50, 25.0), std::pair(100, 25.0),
                                       std::pair(200, 200.0 / 7.0), std::pair(12, 12.0), std::pair(1, 1.0)}) {
    Start(camera_hz);
    for (int i = 0; i <= 2 * camera_hz; ++i) Show(i, 100);
    video_->Finish();
    EXPECT_NEAR(OpenVideo().get(cv::CAP_PROP_FPS), fps, 1e-3);
    EXPECT_EQ(VideoFrames().size(), static_cast<std::size_t>(std::floor(2.0 * fps + 1e-9) + 1)) << camera_hz;
  }
}

TEST_F(FlightVideoTest, AcceptsAnyCameraSize) {
  for (const auto& [width, height, onboard_px] :
       {std::tuple(320, 240, 640), std::tuple(641, 479, 642), std::tuple(1, 1, 480), std::tuple(1, 1000, 2),
        std::tuple(2000, 100, 854), std::tuple(1920, 1080, 854)}) {
    Start(60, width, height);
    Show(0, 200);
    Show(2, 200);
    video_->Finish();
    const std::vector<cv::Mat3b> frames = VideoFrames();
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].size(), cv::Size(onboard_px + kViewHeight_px, kVideoHeight_px)) << width << "x" << height;
    if (onboard_px > 2) {
      EXPECT_NEAR(frames[0](kViewHeight_px / 2 - 15, onboard_px / 2 - 10)[1], 200, 10) << width << "x" << height;
    }
  }
}

TEST_F(FlightVideoTest, ShowsPadCover) {
  Start();
  Show(0, 100, false);
  Show(2, 100, true);
  video_->Finish();
  const std::vector<cv::Mat3b> frames = VideoFrames();
  const cv::Rect right(640, 0, kViewHeight_px, kViewHeight_px);
  // Everything in the unpainted room is white, except for the slightly darker cover.
  EXPECT_GT(cv::norm(frames[0](right), frames[1](right), cv::NORM_INF), 15.0);
}

TEST_F(FlightVideoTest, WritesNoFileWithoutFrames) {
  Start();
  ContinueUntil(1.0);
  video_->Finish();
  EXPECT_FALSE(fs::exists(file_));
}

}  // namespace
}  // namespace touchdown::report
