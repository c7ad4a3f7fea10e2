#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// Reads a video in any format that OpenCV supports. The time of a frame is its time stamp in the file.
class VideoFile final : public Footage {
 public:
  /// Throws InputError for a file that is not a readable video.
  explicit VideoFile(const std::filesystem::path& file);

  const FootageMetadata& metadata() const override { return metadata_; }

  /// Throws InputError when the video has no frames, or ends earlier than its header states by more than 2 frames and
  /// more than 2 %.
  std::optional<FootageFrame> Next() override;

 private:
  std::filesystem::path file_;
  cv::VideoCapture capture_;
  FootageMetadata metadata_;
  std::size_t read_ = 0;
};

}  // namespace touchdown::datasets
