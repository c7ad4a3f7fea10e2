#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::tests {

/// Conditions that make a photograph easy or hard.
struct PhotoConditions {
  double size_fraction = 0.0;  ///< Height of the ring's bounding box over the image height.
  double obliquity_deg = 0.0;  ///< Angle between the line of sight to the pad and its normal.
  double curl = 0.0;           ///< Largest height of the paper within the ring, over the radius of the ring.
  double blur_px = 0.0;        ///< Defocus and motion blur combined.
  double blur_fraction = 0.0;  ///< blur_px over the width of ring or stroke, the narrower of both.
  double glare = 0.0;          ///< Peak brightness over that of the paper; 0: no glare.
  double shadow = 1.0;         ///< Fraction of the light in a shadow; 1: no shadow.
  double exposure = 0.0;       ///< Brightness of the paper over the saturation of the sensor.
  double noise_sigma = 0.0;    ///< Standard deviation, 0 to 255.
  int jpeg_quality = 100;
  std::string marks = "none";  ///< Markings within the ring that the pad description does not list.
  std::string floor = "plain";
};

/// Photograph of a printed pad or of a distractor, with its ground truth.
struct Photograph {
  std::string subject;     ///< "pad", or one of DistractorKinds().
  models::LandingPad pad;  ///< Pad description for the estimator.
  models::CameraModel camera;
  models::Image image;
  PhotoConditions conditions;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  Eigen::Vector2d center_px = Eigen::Vector2d::Zero();  ///< Pixel of the origin of W.
  cv::Rect2d ring_box;                                  ///< Bounding box of the outer boundary of the ring.
};

}  // namespace touchdown::tests
