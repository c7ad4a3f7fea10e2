#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/pad/conic_pose.h"
#include "estimator/pad/undistort_table.h"
#include "models/camera_model.h"

namespace touchdown::estimator::pad {

/// Camera of a downsampled image, each pixel of which is a square of `reduction` x `reduction` camera pixels. Camera
/// and table must outlive this struct.
struct DownsampledCamera {
  const models::CameraModel& camera;
  const UndistortTable& undistort;
  int reduction = 1;

  /// The pixel of the full image at `pixel` of the downsampled image.
  Eigen::Vector2d CameraPixel(const Eigen::Vector2d& pixel) const {
    return reduction * (pixel + Eigen::Vector2d::Constant(0.5)) - Eigen::Vector2d::Constant(0.5);
  }
};

/// Maps between the pixels of a downsampled image and the plane of a ring, whose origin is the ring's center. The
/// camera and table of `view` must outlive the object.
class PadPlane {
 public:
  PadPlane(const CirclePose& ring_pose, const DownsampledCamera& view);

  /// The point of the plane, m, at a pixel of the image.
  Eigen::Vector2d PointAt(const Eigen::Vector2d& pixel) const;

  /// The point of the plane, m, at a point of the normalized image.
  Eigen::Vector2d PointFromNormalized(const Eigen::Vector2d& normalized) const;

  /// The pixel at which a point of the plane, m, appears; nullopt when the camera cannot project the point.
  std::optional<Eigen::Vector2d> PixelAt(const Eigen::Vector2d& point) const;

  /// A point of the plane, m, in the camera frame C, m.
  Eigen::Vector3d InCamera(const Eigen::Vector2d& point) const {
    return pose_.p_CW + point.x() * x_C_ + point.y() * y_C_;
  }

 private:
  CirclePose pose_;
  Eigen::Vector3d x_C_, y_C_;
  DownsampledCamera view_;
};

}  // namespace touchdown::estimator::pad
