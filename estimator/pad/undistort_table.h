#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// Look-up table from distorted to undistorted image coordinates (Sec. IV-B). It is computed once, by Newton's method,
/// at construction.
class UndistortTable {
 public:
  /// `camera` must be valid. Throws InputError when the distortion is not invertible within the image.
  explicit UndistortTable(const models::CameraModel& camera);

  /// The undistorted pixel, at the camera's focal lengths and principal point, for a raw pixel of the image. Between
  /// pixel centers the table is interpolated bilinearly, with an error below 0.001 px for a lens like the default one.
  /// Beyond the outermost pixel centers it is extrapolated.
  Eigen::Vector2d At(const Eigen::Vector2d& pixel) const;

 private:
  const Eigen::Vector2f& Entry(int u, int v) const;

  int width_, height_;
  std::vector<Eigen::Vector2f> entries_;  // Undistorted minus raw pixel, in row-major order.
};

}  // namespace touchdown::estimator::pad
