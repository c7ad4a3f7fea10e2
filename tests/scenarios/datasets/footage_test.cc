// Footage as users have it: folders of pictures, films, recordings, and what is wrong with them.
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
  void PutPicture(const std::string& name, const cv::Mat& picture) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    ASSERT_TRUE(cv::imwrite((folder_ / name).string(), picture));
  }
  /// A film of `count` pictures, 25 a second, that grow brighter by 8 each.
  std::filesystem::path PutFilm(const std::string& name, int count) const {
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

TEST_F(FootageTest, ReadsAFoldersPicturesByTheNumbersInTheirNames) {
  PutPicture("shot10.png", cv::Mat(4, 6, CV_8UC1, cv::Scalar(10)));
  PutPicture("shot9.jpg", cv::Mat(4, 6, CV_8UC3, cv::Scalar::all(90)));
  PutPicture("shot11.PNG", cv::Mat(4, 6, CV_16UC1, cv::Scalar(257 * 11)));
  folder_.Put("notes.txt", "not a picture");
  folder_.Put("inner/shot1.png", "not looked into");
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
  EXPECT_EQ(OpenFootage(folder_.path())->facts().frame_order, estimator::FrameOrder::kUnrelated);
  EXPECT_EQ(OpenFootage(folder_.path())->facts().frame_count, 3u);
}

TEST_F(FootageTest, ReadsAFilmWithItsTimes) {
  const std::filesystem::path film = PutFilm("film.avi", 10);
  const auto footage = OpenFootage(film);
  EXPECT_EQ(footage->facts().frame_order, estimator::FrameOrder::kSequence);
  EXPECT_EQ(footage->facts().frame_count, 10u);
  const std::vector<FootageFrame> frames = ReadAll(film);
  ASSERT_EQ(frames.size(), 10u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].source, "film.avi");
    EXPECT_NEAR(footage->facts().time.ToSeconds(frames[i].mid_exposure.value()), static_cast<double>(i) / 25.0, 1e-5);
    EXPECT_NEAR(frames[i].image.pixels[100], 8.0 * static_cast<double>(i), 3.0);
  }
}

TEST_F(FootageTest, RefusesAFilmThatIsCut) {
  const std::filesystem::path film = PutFilm("film.avi", 30);
  std::filesystem::resize_file(film, std::filesystem::file_size(film) * 6 / 10);
  EXPECT_THAT(Reading(film), ThrowsInputError(HasSubstr("film.avi: ")));
  EXPECT_THAT(Reading(film), ThrowsInputError(HasSubstr("cut")));
  EXPECT_THAT(Reading(folder_.Put("text.mp4", "no film")),
              ThrowsInputError(HasSubstr("text.mp4: no video that can be read")));
}

TEST_F(FootageTest, RefusesWhatIsNotThereAndWhatHoldsNoPictures) {
  EXPECT_THAT(Reading(folder_ / "none"), ThrowsInputError(HasSubstr("none: no such file or folder")));
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("no pictures in this folder")));
  folder_.Put("a.png", "no picture");
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("a.png: no picture that can be read")));
}

/// As in the data sets: no scenario beside it, times since 1970, the body is the IMU.
TEST_F(FootageTest, ReadsAForeignRecording) {
  PutPicture("mav0/cam0/data/1403636579763555584.png", cv::Mat(480, 752, CV_8UC1, cv::Scalar(7)));
  folder_.Put("mav0/cam0/data.csv", "#timestamp [ns],filename\r\n1403636579763555584,1403636579763555584.png\r\n");
  folder_.Put("mav0/cam0/sensor.yaml",
              "T_BS: {cols: 4, rows: 4, data: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}\n"
              "resolution: [752, 480]\nintrinsics: [458, 457, 367, 248]\n"
              "distortion_model: radial-tangential\ndistortion_coefficients: [-0.28, 0.07, 0, 0]\n");
  folder_.Put("mav0/imu0/data.csv", "#t\n1403636579758555392,-0.1,0.15,0.03,8.1,-0.4,-3.3\n");
  for (const char* inside : {"", "mav0"}) {
    const auto footage = OpenFootage(folder_ / inside);
    const FootageFacts& facts = footage->facts();
    EXPECT_EQ(facts.frame_order, estimator::FrameOrder::kSequence);
    EXPECT_EQ(facts.camera.value().fx_px, 458.0);
    EXPECT_EQ(facts.mounting.value().X_BC.translation().x(), 0.1);
    EXPECT_FALSE(facts.latency || facts.pad);
    ASSERT_EQ(facts.imu.size(), 1u);
    EXPECT_EQ(facts.imu[0].sample.specific_force_U, Eigen::Vector3d(8.1, -0.4, -3.3));
    EXPECT_EQ(facts.imu[0].sample.w_WU_U, Eigen::Vector3d(-0.1, 0.15, 0.03));
    EXPECT_FALSE(facts.imu[0].at_rest);
    const auto frame = footage->Next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->mid_exposure, 1403636579763556);
    EXPECT_EQ(frame->image.width, 752);
    EXPECT_FALSE(footage->Next());
  }
}

TEST_F(FootageTest, NamesWhatARecordingLacks) {
  folder_.Put("mav0/cam0/data.csv", "5,5.png\n");
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("5.png: no picture that can be read")));
  folder_.Put("mav0/imu0/data.csv", "5,1,2,3,4,5\n");
  EXPECT_THAT(Reading(folder_.path()), ThrowsInputError(HasSubstr("imu0/data.csv:1: has 6 columns instead of 7")));
}

}  // namespace
}  // namespace touchdown::datasets
