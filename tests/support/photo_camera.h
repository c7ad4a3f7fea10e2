#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "tests/support/photo_paper.h"

namespace touchdown::tests {

/// Draws a camera with a common image size, a narrow to wide field of view, and some distortion.
models::CameraModel DrawCamera(models::RandomStream& random);

/// Camera pose, and bounding box of the outer boundary of the ring in the image.
struct PhotoView {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  cv::Rect2d ring_box;
};

/// Draws a view at `obliquity` that contains the whole ring, with a height of about `size_fraction` of the image
/// height.
PhotoView DrawView(const models::CameraModel& camera, const PhotoPaper& paper, double radius_m, double size_fraction,
                   double obliquity, models::RandomStream& random);

}  // namespace touchdown::tests
