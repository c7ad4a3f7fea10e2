#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace touchdown::report {

/// Frame rate as a fraction, `frames` per `seconds`: {30, 1} is 30 frames/s, {100, 7} is about 14.3 frames/s.
struct FrameRate {
  int frames = 30;
  int seconds = 1;
};

/// Largest video size, in px, that has the aspect ratio of `frame` and does not exceed `max_size` and, except for
/// rounding, `frame`. Width and height are rounded to even numbers, at least 2.
cv::Size VideoSize(const cv::Size& frame, const cv::Size& max_size);

/// Writes an MP4 file with H.264 video for streaming playback in a browser. The index is at the front, there is at
/// least one key frame per second, and any 10 s of video take at most 1,000,000 bytes (detailed frames lose sharpness).
/// Encoding runs in the calling thread.
///
/// The class calls libavcodec directly. OpenCV's VideoWriter does not bound the bit rate (10 s of a flight took 1.7
/// MB), writes a key frame only every 8 s, puts the index at the end, uses all cores and does not report a full disk. A
/// pipe to the program ffmpeg would require ffmpeg at run time.
class VideoWriter {
 public:
  /// Opens the file. Width and height must be even, 2 to 4096 px, and the frame rate positive; throws
  /// std::invalid_argument otherwise. The constructor, Write and Finish throw InputError, with a one-line message that
  /// names the file, when the file cannot be written or the encoder is not available.
  VideoWriter(const std::filesystem::path& file, const cv::Size& size, const FrameRate& rate);
  /// Removes the file unless Finish completed it.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Appends a frame (BGR), which must have the size of the video.
  void Write(const cv::Mat3b& frame);

  /// Number of frames written.
  std::int64_t count() const;

  /// Completes the file. No frame may be written afterwards.
  void Finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::report
