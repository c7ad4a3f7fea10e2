// Directories of images, videos and recordings, valid and invalid.
#include "scenarios/datasets/footage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::ThrowsInputError;

class FootageTest : public ::testing::Test {
 protected:
  void PutImage(const std::string& name, const cv::Mat& image) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    ASSERT_TRUE(cv::imwrite((folder_ / name).string(), image));
  }
  /// Writes a video of `count` frames at 25 frames/s. The gray level increases by 8 per frame.
  std::filesystem::path PutVideo(const std::string& name, int count) const {
    const std::filesystem::path file = folder_ / name;
    cv::VideoWriter writer(file.string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25.0, {64, 48});
    for (int i = 0; i < count; ++i) writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(8 * i)));
    return file;
  }
  std::vector<FootageFrame> ReadAll(const std::filesystem::path& input) const {
    const auto footage = OpenFootage(input);
    std::vector<FootageFrame> frames;
    while (auto frame = footage->Next()) frames.push_back(std::move(*frame));
    return frames;
  }
  auto Reading(const std::filesystem::path& input) const {
    return [this, input] { ReadAll(input); };
  }
  tests::TemporaryFolder folder_;
};

TEST_F(FootageTest, ReadsImagesInNaturalOrderOfTheirNames) {
  PutImage("shot10.png", cv::Mat(4, 6, CV_8UC1, cv::Scalar(10)));
  PutImage("shot9.jpg", cv::Mat(4, 6, CV_8UC3, cv::Scalar::all(90)));
  PutImage("shot11.PNG", cv::Mat(4, 6, CV_16UC1, cv::Scalar(257 * 11)));
  folder_.Put("notes.txt", "not an image");
  folder_.Put("inner/shot1.png", "ignored");
  std::vector<std::string> names;
  std::vector<int> grays;
  for (const FootageFrame& frame : ReadAll(folder_.path())) {
    EXPECT_FALSE(frame.mid_exposure);
    EXPECT_EQ(frame.image.width, 6);
    EXPECT_EQ(frame.image.height, 4);
    names.push_back(frame.source);
    grays.push_back(frame.image.pixels.front());
  }
  EXPECT_THAT(names, ElementsAre("shot9.jpg", "shot10.png", "shot11.PNG"));
  EXPECT_THAT(grays, ElementsAre(90, 10, 11));
  EXPECT_EQ(OpenFootage(folder_.path())->metadata().frame_order, estimator::FrameOrder::kUnrelated);
  EXPECT_EQ(OpenFootage(folder_.path())->metadata().frame_count, 3u);
}

TEST_F(FootageTest, ReadsAVideoWithItsTimes) {
  const std::filesystem::path video = PutVideo("video.avi", 10);
  const auto footage = OpenFootage(video);
  EXPECT_EQ(footage->metadata().frame_order, estimator::FrameOrder::kSequence);
  EXPECT_EQ(footage->metadata().frame_count, 10u);
  const std::vector<FootageFrame> frames = ReadAll(video);
  ASSERT_EQ(frames.size(), 10u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].source, "video.avi");
    EXPECT_NEAR(footage->metadata().time.ToSeconds(frames[i].mid_exposure.value()), static_cast<double>(i) / 25.0,
                1e-5);
    EXPECT_NEAR(frames[i].image.pixels[100], 8.0 * static_cast<double>(i), 3.0);
  }
}

TEST_F(FootageTest, RejectsATruncatedVideo) {
  const std::filesystem::path video = PutVideo("video.avi", 30);
  std::filesystem::resize_file(video, std::filesystem::file_size(video) * 6 / 10);
  EXPECT_THAT(Reading(video), ThrowsInputError(HasSubstr("video.avi: ")));
  EXPECT_THAT(Reading(video), ThrowsInputError(HasSubstr("truncated")));
  EXPECT_THAT(Reading(folder_.Put("text.mp4", "not a video")),
              ThrowsInputError(HasSubstr("text.mp4: not a readable video")));
}

TEST_F(FootageTest, RejectsMissingFilesAndDirectoriesWithoutImages) {
  EXPECT_THAT(Reading(folder_ / "none"), ThrowsInputError(HasSubstr("none: no such file or directory")));
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("no images in this directory")));
  folder_.Put("a.png", "not an image");
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("a.png: not a readable image")));
}

/// A recording as in the EuRoC data sets: no scenario, Unix times, the body frame is the IMU frame.
TEST_F(FootageTest, ReadsAEurocDataSet) {
  PutImage("mav0/cam0/data/1403636579763555584.png", cv::Mat(480, 752, CV_8UC1, cv::Scalar(7)));
  folder_.Put("mav0/cam0/data.csv", "#timestamp [ns],filename\r\n1403636579763555584,1403636579763555584.png\r\n");
  folder_.Put("mav0/cam0/sensor.yaml",
              "T_BS: {cols: 4, rows: 4, data: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}\n"
              "resolution: [752, 480]\nintrinsics: [458, 457, 367, 248]\n"
              "distortion_model: radial-tangential\ndistortion_coefficients: [-0.28, 0.07, 0, 0]\n");
  folder_.Put("mav0/imu0/data.csv", "#t\n1403636579758555392,-0.1,0.15,0.03,8.1,-0.4,-3.3\n");
  for (const char* inside : {"", "mav0"}) {
    const auto footage = OpenFootage(folder_ / inside);
    const FootageMetadata& metadata = footage->metadata();
    EXPECT_EQ(metadata.frame_order, estimator::FrameOrder::kSequence);
    EXPECT_EQ(metadata.camera.value().fx_px, 458.0);
    EXPECT_EQ(metadata.mounting.value().X_BC.translation().x(), 0.1);
    EXPECT_FALSE(metadata.latency || metadata.pad);
    ASSERT_EQ(metadata.imu.size(), 1u);
    EXPECT_EQ(metadata.imu[0].sample.specific_force_U, Eigen::Vector3d(8.1, -0.4, -3.3));
    EXPECT_EQ(metadata.imu[0].sample.w_WU_U, Eigen::Vector3d(-0.1, 0.15, 0.03));
    EXPECT_FALSE(metadata.imu[0].at_rest);
    const auto frame = footage->Next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->mid_exposure, 1403636579763556);
    EXPECT_EQ(frame->image.width, 752);
    EXPECT_FALSE(footage->Next());
  }
}

TEST_F(FootageTest, NamesInvalidFilesOfARecording) {
  folder_.Put("mav0/cam0/data.csv", "5,5.png\n");
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("5.png: not a readable image")));
  folder_.Put("mav0/imu0/data.csv", "5,1,2,3,4,5\n");
  EXPECT_THAT(Reading(folder_.path()),
              ThrowsInputError(HasSubstr("imu0/data.csv:1: has 6 columns; required: at least 7")));
}

}  // namespace
}  // namespace touchdown::datasets
