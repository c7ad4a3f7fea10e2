#include "estimator/pad/pad_plane.h"

#include <Eigen/Geometry>

namespace touchdown::estimator::pad {

using Eigen::Vector2d;
using Eigen::Vector3d;

PadPlane::PadPlane(const CirclePose& ring_pose, const DownsampledCamera& view)
    : pose_(ring_pose), x_C_(ring_pose.n_C.unitOrthogonal()), y_C_(ring_pose.n_C.cross(x_C_)), view_(view) {}

Vector2d PadPlane::PointAt(const Vector2d& pixel) const {
  return PointFromNormalized(view_.camera.NormalizedFromPixel(view_.undistort.At(view_.CameraPixel(pixel))));
}

Vector2d PadPlane::PointFromNormalized(const Vector2d& normalized) const {
  const Vector3d ray_C = normalized.homogeneous();
  const Vector3d p_C = ray_C * (pose_.n_C.dot(pose_.p_CW) / pose_.n_C.dot(ray_C));
  return {x_C_.dot(p_C - pose_.p_CW), y_C_.dot(p_C - pose_.p_CW)};
}

std::optional<Vector2d> PadPlane::PixelAt(const Vector2d& point) const {
  const auto camera_pixel = view_.camera.Project(InCamera(point));
  if (!camera_pixel) return std::nullopt;
  return (*camera_pixel + Vector2d::Constant(0.5)) / view_.reduction - Vector2d::Constant(0.5);
}

}  // namespace touchdown::estimator::pad
