#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <opencv2/core/types.hpp>

#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/report/video_writer.h"

namespace touchdown::report {

/// A film of footage with what the estimator saw drawn into it, and a line that tells the frame, its time and its
/// status.
class FootageVideo {
 public:
  /// Poses are of the body when `setup` has a mounting, of the camera otherwise. Throws as VideoWriter does.
  FootageVideo(const std::filesystem::path& file, const datasets::FootageSetup& setup,
               const datasets::FootageFacts& facts);

  /// The next frame, of the camera's size. Throws InputError when it cannot be written.
  void Add(const datasets::FootageFrame& frame, const datasets::FootageEstimate& estimate);

  /// Completes the film.
  void Finish() { writer_.Finish(); }

 private:
  models::CameraModel camera_;
  double axis_length_m_;
  Eigen::Isometry3d X_BC_;
  models::TimeBase time_;
  cv::Size size_;
  VideoWriter writer_;
};

}  // namespace touchdown::report
