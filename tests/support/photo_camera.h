#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "tests/support/photo_paper.h"

namespace touchdown::tests {

/// A camera of any common size, from narrow to wide, with some distortion.
models::CameraModel DrawCamera(models::RandomStream& random);

/// Where a camera is, and the box of the ring's outer boundary in its picture.
struct PhotoView {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  cv::Rect2d ring_box;
};

/// A view that has the ring whole, about `size_fraction` of the picture's height high, under `obliquity`.
PhotoView DrawView(const models::CameraModel& camera, const PhotoPaper& paper, double radius_m, double size_fraction,
                   double obliquity, models::RandomStream& random);

}  // namespace touchdown::tests
