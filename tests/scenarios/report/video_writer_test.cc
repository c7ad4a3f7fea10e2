#include "scenarios/report/video_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "tests/support/disk_of_size.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

class VideoWriterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Content(const std::string& name = "film.mp4") const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("video_writer_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
  const fs::path file_ = folder_ / "film.mp4";
};

/// A plain picture whose gray tells its number, with a red square on it.
cv::Mat3b Numbered(int number, const cv::Size& size) {
  cv::Mat3b picture(size, cv::Vec3b::all(static_cast<std::uint8_t>(40 + 2 * (number % 80))));
  picture(cv::Rect(size.width / 4, size.height / 4, size.width / 4, size.height / 4)) = cv::Vec3b(20, 30, 220);
  return picture;
}

void WriteNumbered(const fs::path& file, const cv::Size& size, const FrameRate& rate, int count) {
  VideoWriter writer(file, size, rate);
  for (int i = 0; i < count; ++i) writer.Write(Numbered(i, size));
  EXPECT_EQ(writer.count(), count);
  writer.Finish();
}

TEST_F(VideoWriterTest, WritesAFilmThatReadsBackAsItWasPutIn) {
  const cv::Size size(320, 240);
  WriteNumbered(file_, size, {.pictures = 30, .seconds = 1}, 70);
  cv::VideoCapture film(file_.string());
  ASSERT_TRUE(film.isOpened());
  EXPECT_EQ(film.get(cv::CAP_PROP_FRAME_WIDTH), 320);
  EXPECT_EQ(film.get(cv::CAP_PROP_FRAME_HEIGHT), 240);
  EXPECT_EQ(film.get(cv::CAP_PROP_FPS), 30.0);
  EXPECT_EQ(film.get(cv::CAP_PROP_FRAME_COUNT), 70);
  EXPECT_EQ(film.get(cv::CAP_PROP_FOURCC), cv::VideoWriter::fourcc('a', 'v', 'c', '1'));
  cv::Mat picture;
  for (int i = 0; i < 70; ++i) {
    ASSERT_TRUE(film.read(picture)) << i;
    const cv::Mat3b expected = Numbered(i, size);
    EXPECT_LT(cv::norm(picture, expected, cv::NORM_L1) / static_cast<double>(3 * expected.total()), 4.0) << i;
  }
  EXPECT_FALSE(film.read(picture));
}

TEST_F(VideoWriterTest, LetsAPlayerSeek) {
  WriteNumbered(file_, {64, 48}, {.pictures = 30, .seconds = 1}, 75);
  cv::VideoCapture film(file_.string());
  for (const int number : {50, 3, 74, 31, 0}) {
    film.set(cv::CAP_PROP_POS_FRAMES, number);
    cv::Mat picture;
    ASSERT_TRUE(film.read(picture));
    EXPECT_NEAR(picture.at<cv::Vec3b>(2, 2)[1], 40 + 2 * number, 1.5) << number;
  }
}

/// The 32 bits, most significant first, at a place of a file.
std::uint32_t NumberAt(const std::string& content, std::size_t place) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(content.at(place + i));
  return number;
}

TEST_F(VideoWriterTest, HasItsIndexAtTheFrontAndAKeyFrameEverySecond) {
  for (const FrameRate rate : {FrameRate{30, 1}, FrameRate{100, 7}, FrameRate{1, 1}, FrameRate{25, 1}}) {
    const int count = 5 * rate.pictures / rate.seconds + 1;
    WriteNumbered(file_, {64, 48}, rate, count);
    const std::string content = Content();
    EXPECT_LT(content.find("moov"), content.find("mdat"));
    const std::size_t sync_samples = content.find("stss");
    if (sync_samples == std::string::npos) {
      EXPECT_EQ(rate.pictures / rate.seconds, 1) << "every picture is a key frame";
      continue;
    }
    const std::uint32_t keys = NumberAt(content, sync_samples + 8);
    std::uint32_t previous = 1;
    for (std::uint32_t i = 0; i <= keys; ++i) {
      const std::uint32_t next =
          i < keys ? NumberAt(content, sync_samples + 12 + 4 * i) : static_cast<std::uint32_t>(count);
      EXPECT_LE((next - previous) * static_cast<std::uint32_t>(rate.seconds),
                static_cast<std::uint32_t>(rate.pictures));
      previous = next;
    }
  }
}

/// Pictures of strong noise; each is unlike the seven before it.
std::vector<cv::Mat3b> NoisyPictures(const cv::Size& size) {
  cv::RNG random(1);
  std::vector<cv::Mat3b> pictures(8);
  for (cv::Mat3b& picture : pictures) {
    picture.create(size);
    random.fill(picture, cv::RNG::NORMAL, 128.0, 60.0);
  }
  return pictures;
}

TEST_F(VideoWriterTest, TakesNoMoreThanAMegabyteForTenSecondsOfNoise) {
  const cv::Size size(1280, 512);
  const std::vector<cv::Mat3b> noise = NoisyPictures(size);
  const auto bytes_of = [&](int still, int noisy) {
    VideoWriter writer(file_, size, {});
    for (int i = 0; i < still; ++i) writer.Write(cv::Mat3b(size, cv::Vec3b::all(100)));
    for (int i = 0; i < noisy; ++i) writer.Write(noise[static_cast<std::size_t>(i) % noise.size()]);
    writer.Finish();
    return static_cast<std::int64_t>(fs::file_size(file_));
  };
  EXPECT_LE(bytes_of(0, 300), 1'000'000);
  // What a quiet time has saved does not make the ten seconds after it larger.
  EXPECT_LE(bytes_of(60, 300) - bytes_of(60, 1), 1'000'000);
}

TEST_F(VideoWriterTest, LeavesNothingOfAFilmThatIsNotFinished) {
  {
    VideoWriter writer(file_, {64, 48}, {});
    writer.Write(Numbered(0, {64, 48}));
    EXPECT_TRUE(fs::exists(file_));
  }
  EXPECT_FALSE(fs::exists(file_));
}

/// A noisy video of 3 s.
void WriteNoise(const fs::path& file) {
  const std::vector<cv::Mat3b> noise = NoisyPictures({640, 480});
  VideoWriter writer(file, noise[0].size(), {});
  for (std::size_t i = 0; i < 90; ++i) writer.Write(noise[i % noise.size()]);
  writer.Finish();
}

TEST_F(VideoWriterTest, TellsOfAFullDiskAndLeavesNothing) {
  ASSERT_NO_THROW(WriteNoise(file_));
  const auto whole = static_cast<rlim_t>(fs::file_size(file_));
  fs::remove(file_);
  // Full at the start, in the middle, and while the index is put to the front.
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{50'000}, whole - 100}) {
    const tests::DiskOfSize disk(bytes);
    EXPECT_THAT([&] { WriteNoise(file_); }, tests::ThrowsInputError("video film.mp4: File too large")) << bytes;
    EXPECT_FALSE(fs::exists(file_));
  }
}

TEST_F(VideoWriterTest, TellsOfAPlaceThatCannotBeWritten) {
  EXPECT_THAT([&] { WriteNoise(folder_ / "none" / "film.mp4"); },
              tests::ThrowsInputError("video film.mp4: No such file or directory"));
  EXPECT_THAT([&] { WriteNoise(folder_); },
              tests::ThrowsInputError("video " + folder_.filename().string() + ": Is a directory"));
  EXPECT_TRUE(fs::is_directory(folder_));
  EXPECT_THAT([&] { WriteNoise("/proc/film.mp4"); }, tests::ThrowsInputError(testing::StartsWith("video film.mp4: ")));
}

TEST_F(VideoWriterTest, RefusesSizesThatAFilmCannotHave) {
  for (const cv::Size& size : {cv::Size(0, 48), cv::Size(64, 47), cv::Size(65, 48), cv::Size(4098, 48)}) {
    EXPECT_THROW(VideoWriter(file_, size, {}), std::invalid_argument);
  }
  EXPECT_THROW(VideoWriter(file_, {64, 48}, {.pictures = 0, .seconds = 1}), std::invalid_argument);
  EXPECT_FALSE(fs::exists(file_));
}

TEST(VideoSize, IsEvenAndOfThePicturesShapeWithinTheMost) {
  const cv::Size most(1280, 720);
  EXPECT_EQ(VideoSize({640, 480}, most), cv::Size(640, 480));
  EXPECT_EQ(VideoSize({641, 479}, most), cv::Size(642, 480));
  EXPECT_EQ(VideoSize({4000, 3000}, most), cv::Size(960, 720));
  EXPECT_EQ(VideoSize({4000, 1}, most), cv::Size(1280, 2));
  EXPECT_EQ(VideoSize({1, 1}, most), cv::Size(2, 2));
  EXPECT_EQ(VideoSize({1281, 100}, {1281, 721}), cv::Size(1280, 100));
}

}  // namespace
}  // namespace touchdown::report
