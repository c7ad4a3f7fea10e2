#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// The look-up table from distorted to undistorted image coordinates that is computed once, by Newton's method, when
/// the vision starts (Sec. IV-B).
class UndistortTable {
 public:
  /// `camera` must be valid.
  explicit UndistortTable(const models::CameraModel& camera);

  /// The undistorted pixel, at the camera's own focal lengths and principal point, of a raw pixel of the image, which
  /// need not be whole: between pixel centers the table is interpolated bilinearly (off by less than 0.001 px for a
  /// lens like the default one), beyond the outermost ones it is continued.
  Eigen::Vector2d At(const Eigen::Vector2d& pixel) const;

 private:
  const Eigen::Vector2f& Entry(int u, int v) const;

  int width_, height_;
  std::vector<Eigen::Vector2f> entries_;  // Of pixel minus raw pixel, row by row.
};

}  // namespace touchdown::estimator::pad
