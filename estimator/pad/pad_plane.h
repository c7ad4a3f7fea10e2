#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/pad/conic_pose.h"
#include "estimator/pad/undistort_table.h"
#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// How an image came out of a camera's: one pixel of it is a square of `reduction` pixels of the camera. Camera and
/// table must outlive it.
struct DownsampledCamera {
  const models::CameraModel& camera;
  const UndistortTable& undistort;
  int reduction = 1;

  /// In the camera's own image.
  Eigen::Vector2d CameraPixel(const Eigen::Vector2d& pixel) const {
    return reduction * (pixel + Eigen::Vector2d::Constant(0.5)) - Eigen::Vector2d::Constant(0.5);
  }
};

/// The plane on which a ring lies, with the ring's center as origin, in a reduced image. What it is made of must
/// outlive it.
class PadPlane {
 public:
  PadPlane(const CirclePose& ring_pose, const DownsampledCamera& view);

  /// Where on the plane, m, a pixel of the image looks.
  Eigen::Vector2d PointAt(const Eigen::Vector2d& pixel) const;

  /// The same of a point of the normalized image.
  Eigen::Vector2d PointAlong(const Eigen::Vector2d& normalized) const;

  /// The pixel that sees a point of the plane; nullopt where none does.
  std::optional<Eigen::Vector2d> PixelAt(const Eigen::Vector2d& point) const;

  /// In the camera frame C.
  Eigen::Vector3d InCamera(const Eigen::Vector2d& point) const {
    return pose_.p_CW + point.x() * x_C_ + point.y() * y_C_;
  }

 private:
  CirclePose pose_;
  Eigen::Vector3d x_C_, y_C_;
  DownsampledCamera view_;
};

}  // namespace touchdown::estimator::pad
