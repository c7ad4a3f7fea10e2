#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace touchdown::report {

/// `pictures` in `seconds`: {30, 1} is 30 a second, {100, 7} about 14.3.
struct FrameRate {
  int pictures = 30;
  int seconds = 1;
};

/// The largest size that a film of such pictures can have within `most`, no larger than the pictures themselves: of
/// their shape, rounded to even numbers.
cv::Size VideoSize(const cv::Size& picture, const cv::Size& most);

/// An MP4 file with H.264 that a browser plays, also while it loads: index at the front, a key frame at least once a
/// second, and in any ten seconds at most 1,000,000 bytes, whatever the pictures hold (where they are busy, sharpness
/// gives way). It encodes in the calling thread.
///
/// libavcodec is used as it is, not through OpenCV's VideoWriter: that one has no bound on the bit rate (10 s of a
/// flight's film were 1.7 MB), makes a key frame every 8 s, puts the index at the end, takes all cores and says nothing
/// of a full disk; and a pipe to the program ffmpeg would need it at run time.
class VideoWriter {
 public:
  /// `size` has even numbers from 2 to 4096 (throws std::invalid_argument otherwise). Throws InputError, as everything
  /// below, when the file cannot be written or there is no encoder: one line that names the file.
  VideoWriter(const std::filesystem::path& file, const cv::Size& size, const FrameRate& rate);
  /// Removes the file unless it is finished.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// The next picture: of the film's size, blue, green, red.
  void Write(const cv::Mat3b& picture);

  /// How many pictures there are.
  std::int64_t count() const;

  /// Completes the file: nothing can be written after it.
  void Finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::report
