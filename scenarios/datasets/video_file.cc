#include "scenarios/datasets/video_file.h"

#include <fmt/format.h>

#include <cmath>

#include "models/error.h"
#include "scenarios/datasets/gray_image.h"

namespace touchdown::datasets {

VideoFile::VideoFile(const std::filesystem::path& file) : file_(file) {
  if (!capture_.open(file.string(), cv::CAP_FFMPEG)) {
    throw InputError(fmt::format("{}: not a readable video, or truncated", file.string()));
  }
  metadata_.frame_order = estimator::FrameOrder::kSequence;
  if (const double rate = capture_.get(cv::CAP_PROP_FPS); rate > 0.0) metadata_.frames_per_s = rate;
  metadata_.frame_count = static_cast<std::size_t>(std::max(0.0, capture_.get(cv::CAP_PROP_FRAME_COUNT)));
}

std::optional<FootageFrame> VideoFile::Next() {
  cv::Mat image;
  if (!capture_.read(image)) {
    // For containers without a frame count, OpenCV estimates one from duration and frame rate.
    constexpr double kCountTolerance = 0.02, kFewFrames = 2.0;
    const auto claimed = static_cast<double>(metadata_.frame_count), read = static_cast<double>(read_);
    if (read_ == 0 || claimed - read > std::max(kFewFrames, kCountTolerance * claimed)) {
      throw InputError(
          fmt::format("{}: truncated video: ends after {} of {} frames", file_.string(), read_, metadata_.frame_count));
    }
    return std::nullopt;
  }
  ++read_;
  constexpr double kMillisecond_s = 1e-3;
  const double time_s = capture_.get(cv::CAP_PROP_POS_MSEC) * kMillisecond_s;
  return FootageFrame{file_.filename().string(), metadata_.time.FromSeconds(time_s), ToGrayImage(image)};
}

}  // namespace touchdown::datasets
