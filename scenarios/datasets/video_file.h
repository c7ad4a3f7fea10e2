#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// A video, in any format that OpenCV reads. A frame's time is the one that the file gives it, from its beginning.
class VideoFile final : public Footage {
 public:
  /// Throws InputError for a file that is no video, or has no frames.
  explicit VideoFile(const std::filesystem::path& file);

  const FootageFacts& facts() const override { return facts_; }

  /// Throws InputError when the video ends before as many frames as it claims to have.
  std::optional<FootageFrame> Next() override;

 private:
  std::filesystem::path file_;
  cv::VideoCapture capture_;
  FootageFacts facts_;
  std::size_t read_ = 0;
};

}  // namespace touchdown::datasets
