#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <opencv2/core/types.hpp>

#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/report/video_writer.h"

namespace touchdown::report {

/// Writes a video of recorded footage. Each frame is annotated with the overlay of the estimator and the estimated
/// pose, and has a caption with time, source and status.
class FootageVideo {
 public:
  /// The estimated poses are body poses when `setup` has a mounting, and camera poses otherwise. Throws the exceptions
  /// of VideoWriter.
  FootageVideo(const std::filesystem::path& file, const datasets::FootageSetup& setup,
               const datasets::FootageMetadata& metadata);

  /// Appends a frame, which must have the size of the camera. Throws InputError when it cannot be written.
  void Add(const datasets::FootageFrame& frame, const datasets::FootageEstimate& estimate);

  /// Completes the file. Throws InputError when it cannot be written.
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
