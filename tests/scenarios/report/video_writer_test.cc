#include "scenarios/report/video_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "tests/support/file_size_limit.h"
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

  std::string Content(const std::string& name = "video.mp4") const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("video_writer_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
  const fs::path file_ = folder_ / "video.mp4";
};

/// Frame of uniform gray, which encodes `number`, with a red square.
cv::Mat3b NumberedFrame(int number, const cv::Size& size) {
  cv::Mat3b frame(size, cv::Vec3b::all(static_cast<std::uint8_t>(40 + 2 * (number % 80))));
  frame(cv::Rect(size.width / 4, size.height / 4, size.width / 4, size.height / 4)) = cv::Vec3b(20, 30, 220);
  return frame;
}

void WriteNumbered(const fs::path& file, const cv::Size& size, const FrameRate& rate, int count) {
  VideoWriter writer(file, size, rate);
  for (int i = 0; i < count; ++i) writer.Write(NumberedFrame(i, size));
  EXPECT_EQ(writer.count(), count);
  writer.Finish();
}

TEST_F(VideoWriterTest, DecodedFramesEqualWrittenFrames) {
  const cv::Size size(320, 240);
  WriteNumbered(file_, size, {.frames = 30, .seconds = 1}, 70);
  cv::VideoCapture video(file_.string());
  ASSERT_TRUE(video.isOpened());
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 320);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_HEIGHT), 240);
  EXPECT_EQ(video.get(cv::CAP_PROP_FPS), 30.0);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), 70);
  EXPECT_EQ(video.get(cv::CAP_PROP_FOURCC), cv::VideoWriter::fourcc('a', 'v', 'c', '1'));
  cv::Mat frame;
  for (int i = 0; i < 70; ++i) {
    ASSERT_TRUE(video.read(frame)) << i;
    const cv::Mat3b expected = NumberedFrame(i, size);
    EXPECT_LT(cv::norm(frame, expected, cv::NORM_L1) / static_cast<double>(3 * expected.total()), 4.0) << i;
  }
  EXPECT_FALSE(video.read(frame));
}

TEST_F(VideoWriterTest, SupportsSeeking) {
  WriteNumbered(file_, {64, 48}, {.frames = 30, .seconds = 1}, 75);
  cv::VideoCapture video(file_.string());
  for (const int number : {50, 3, 74, 31, 0}) {
    video.set(cv::CAP_PROP_POS_FRAMES, number);
    cv::Mat frame;
    ASSERT_TRUE(video.read(frame));
    EXPECT_NEAR(frame.at<cv::Vec3b>(2, 2)[1], 40 + 2 * number, 1.5) << number;
  }
}

/// Big-endian 32-bit number at an offset.
std::uint32_t NumberAt(const std::string& content, std::size_t offset) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(content.at(offset + i));
  return number;
}

TEST_F(VideoWriterTest, HasIndexAtFrontAndKeyFrameEverySecond) {
  for (const FrameRate rate : {FrameRate{30, 1}, FrameRate{100, 7}, FrameRate{1, 1}, FrameRate{25, 1}}) {
    const int count = 5 * rate.frames / rate.seconds + 1;
    WriteNumbered(file_, {64, 48}, rate, count);
    const std::string content = Content();
    EXPECT_LT(content.find("moov"), content.find("mdat"));
    const std::size_t sync_samples = content.find("stss");
    if (sync_samples == std::string::npos) {
      EXPECT_EQ(rate.frames / rate.seconds, 1) << "every frame is a key frame";
      continue;
    }
    const std::uint32_t keys = NumberAt(content, sync_samples + 8);
    std::uint32_t previous = 1;
    for (std::uint32_t i = 0; i <= keys; ++i) {
      const std::uint32_t next =
          i < keys ? NumberAt(content, sync_samples + 12 + 4 * i) : static_cast<std::uint32_t>(count);
      EXPECT_LE((next - previous) * static_cast<std::uint32_t>(rate.seconds), static_cast<std::uint32_t>(rate.frames));
      previous = next;
    }
  }
}

/// Eight different frames of strong noise.
std::vector<cv::Mat3b> NoisyFrames(const cv::Size& size) {
  cv::RNG random(1);
  std::vector<cv::Mat3b> frames(8);
  for (cv::Mat3b& frame : frames) {
    frame.create(size);
    random.fill(frame, cv::RNG::NORMAL, 128.0, 60.0);
  }
  return frames;
}

TEST_F(VideoWriterTest, WritesAtMostOneMegabyteForTenSecondsOfNoise) {
  const cv::Size size(1280, 512);
  const std::vector<cv::Mat3b> noise = NoisyFrames(size);
  const auto bytes_of = [&](int still, int noisy) {
    VideoWriter writer(file_, size, {});
    for (int i = 0; i < still; ++i) writer.Write(cv::Mat3b(size, cv::Vec3b::all(100)));
    for (int i = 0; i < noisy; ++i) writer.Write(noise[static_cast<std::size_t>(i) % noise.size()]);
    writer.Finish();
    return static_cast<std::int64_t>(fs::file_size(file_));
  };
  EXPECT_LE(bytes_of(0, 300), 1'000'000);
  // Bits saved in a still period must not enlarge the following 10 s.
  EXPECT_LE(bytes_of(60, 300) - bytes_of(60, 1), 1'000'000);
}

TEST_F(VideoWriterTest, RemovesUnfinishedFile) {
  {
    VideoWriter writer(file_, {64, 48}, {});
    writer.Write(NumberedFrame(0, {64, 48}));
    EXPECT_TRUE(fs::exists(file_));
  }
  EXPECT_FALSE(fs::exists(file_));
}

/// A noisy video of 3 s.
void WriteNoise(const fs::path& file) {
  const std::vector<cv::Mat3b> noise = NoisyFrames({640, 480});
  VideoWriter writer(file, noise[0].size(), {});
  for (std::size_t i = 0; i < 90; ++i) writer.Write(noise[i % noise.size()]);
  writer.Finish();
}

TEST_F(VideoWriterTest, ThrowsForFullDiskAndRemovesFile) {
  ASSERT_NO_THROW(WriteNoise(file_));
  const auto full_size = static_cast<rlim_t>(fs::file_size(file_));
  fs::remove(file_);
  // The disk is full at the start, in the middle, and while the index is moved to the front.
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{50'000}, full_size - 100}) {
    const tests::FileSizeLimit disk(bytes);
    EXPECT_THAT([&] { WriteNoise(file_); }, tests::ThrowsInputError("video video.mp4: File too large")) << bytes;
    EXPECT_FALSE(fs::exists(file_));
  }
}

TEST_F(VideoWriterTest, ThrowsForUnwritablePath) {
  EXPECT_THAT([&] { WriteNoise(folder_ / "none" / "video.mp4"); },
              tests::ThrowsInputError("video video.mp4: No such file or directory"));
  EXPECT_THAT([&] { WriteNoise(folder_); },
              tests::ThrowsInputError("video " + folder_.filename().string() + ": Is a directory"));
  EXPECT_TRUE(fs::is_directory(folder_));
  EXPECT_THAT([&] { WriteNoise("/proc/video.mp4"); },
              tests::ThrowsInputError(testing::StartsWith("video video.mp4: ")));
}

TEST_F(VideoWriterTest, ThrowsForInvalidSizeOrRate) {
  for (const cv::Size& size : {cv::Size(0, 48), cv::Size(64, 47), cv::Size(65, 48), cv::Size(4098, 48)}) {
    EXPECT_THROW(VideoWriter(file_, size, {}), std::invalid_argument);
  }
  EXPECT_THROW(VideoWriter(file_, {64, 48}, {.frames = 0, .seconds = 1}), std::invalid_argument);
  EXPECT_FALSE(fs::exists(file_));
}

TEST(VideoSize, IsEvenKeepsAspectRatioAndRespectsLimit) {
  const cv::Size max_size(1280, 720);
  EXPECT_EQ(VideoSize({640, 480}, max_size), cv::Size(640, 480));
  EXPECT_EQ(VideoSize({641, 479}, max_size), cv::Size(642, 480));
  EXPECT_EQ(VideoSize({4000, 3000}, max_size), cv::Size(960, 720));
  EXPECT_EQ(VideoSize({4000, 1}, max_size), cv::Size(1280, 2));
  EXPECT_EQ(VideoSize({1, 1}, max_size), cv::Size(2, 2));
  EXPECT_EQ(VideoSize({1281, 100}, {1281, 721}), cv::Size(1280, 100));
}

}  // namespace
}  // namespace touchdown::report
