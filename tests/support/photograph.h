#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::tests {

/// What makes a photograph easy or hard.
struct PhotoConditions {
  double size_fraction = 0.0;  ///< Height of the ring's box over the image's.
  double obliquity_deg = 0.0;  ///< Between the line of sight to the pad and its normal.
  double curl = 0.0;           ///< Largest height of the paper's surface within the ring, over the ring's radius.
  double blur_px = 0.0;        ///< Defocus and motion together.
  double blur_fraction = 0.0;  ///< The same over the narrower of ring and H's stroke, as seen.
  double glare = 0.0;          ///< Of the paper's brightness, at the patch's middle; 0 without.
  double shadow = 1.0;         ///< Light left within a shadow; 1 without.
  double exposure = 0.0;       ///< Brightness of the paper, 1 being the sensor's most.
  double noise_sigma = 0.0;    ///< Of 255.
  int jpeg_quality = 100;
  std::string marks = "none";  ///< Markings within the ring that the pad description does not list.
  std::string floor = "plain";
};

/// A photograph of a printed sheet under room light, or of something that is not the pad, with its truth.
struct Photograph {
  std::string subject;     ///< "pad", or one of DistractorKinds().
  models::LandingPad pad;  ///< As the estimator assumes it.
  models::CameraModel camera;
  models::Image image;
  PhotoConditions conditions;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  Eigen::Vector2d center_px = Eigen::Vector2d::Zero();  ///< Where W's origin is seen.
  cv::Rect2d ring_box;                                  ///< Of the ring's outer boundary, on the curled paper.
};

}  // namespace touchdown::tests
