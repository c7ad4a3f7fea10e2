#include "scenarios/report/contact_sheet.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace touchdown::report {
namespace {

cv::Mat Decode(const std::string& png) {
  return cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_COLOR);
}

TEST(ContactSheet, ReturnsNulloptWithoutFrames) {
  EXPECT_FALSE(ContactSheet(models::CameraModel(), models::TimeBase()).Png());
}

TEST(ContactSheet, HasBoundedSizeForAnyAspectRatio) {
  for (const auto& [width, height] : {std::pair(1, 4000), std::pair(4000, 1), std::pair(2000, 2000)}) {
    models::CameraModel camera;
    camera.width_px = width;
    camera.height_px = height;
    ContactSheet sheet(camera, models::TimeBase());
    models::CameraFrame frame;
    frame.image = models::Image(width, height, 128);
    for (int i = 0; i < 12; ++i) sheet.OnFrame(frame, {}, {});
    const cv::Mat image = Decode(sheet.Png().value());
    EXPECT_LE(image.cols, 4 * 480);
    EXPECT_LE(image.rows, 3 * 720);
    EXPECT_FALSE(image.empty());
  }
}

TEST(ContactSheet, ShowsTwelveFramesFromStartToEndOfLongFlight) {
  models::CameraModel camera;
  camera.width_px = 64;
  camera.height_px = 48;
  ContactSheet sheet(camera, models::TimeBase());
  constexpr int kFrames = 1000;
  for (int i = 0; i < kFrames; ++i) {
    models::CameraFrame frame;
    frame.mid_exposure = 20 * i;
    frame.image = models::Image(64, 48, static_cast<std::uint8_t>(i * 250 / kFrames));
    sheet.OnFrame(frame, {}, {});
  }
  const cv::Mat image = Decode(sheet.Png().value());
  ASSERT_EQ(image.cols, 4 * 480);
  ASSERT_EQ(image.rows, 3 * 360);
  int previous = -1;
  for (int tile = 0; tile < 12; ++tile) {
    const int gray = image.at<cv::Vec3b>(360 * (tile / 4) + 330, 480 * (tile % 4) + 450)[0];
    EXPECT_GT(gray, previous);
    if (tile > 0) {
      EXPECT_NEAR(gray - previous, 250.0 / 11.0, 12.0);
    }
    previous = gray;
  }
  EXPECT_GT(previous, 220);
}

}  // namespace
}  // namespace touchdown::report
