#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "scenarios/training/classifier_shapes.h"
#include "sim/scene/scene.h"

namespace touchdown::training {

/// Distribution of the views of the training set.
struct ViewConfig {
  double min_distance_m = 0.12;  ///< Minimum distance from the camera to the target; uniform in log scale.
  double max_distance_m = 3.0;   ///< Maximum distance.
  double max_tilt_deg = 55.0;
  /// Fraction of hovering views: nearly level, at rest, in focus and aligned with the axes of the target.
  double hovering_fraction = 0.35;
  double speed_scale_m_s = 1.5;   ///< Scale of the camera velocity during the exposure, except when hovering.
  double rate_scale_rad_s = 1.0;  ///< Scale of its angular velocity.
  double min_exposure_s = 0.001;
  double max_exposure_s = 0.012;
  double max_defocus_px = 1.5;                      ///< Largest standard deviation of the lens blur.
  std::vector<double> noise_sigmas{0.5, 3.0, 7.0};  ///< 1-sigma of 255; the last is unused below contrast 0.6.
  double min_contrast = 0.45;                       ///< Smallest contrast; the renderer has 1.

  /// Throws InputError when a range is empty or a number is not finite.
  void Validate() const;
};

/// Camera pose, motion and image quality of one frame.
struct View {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();  ///< At mid-exposure.
  Eigen::Vector3d v_WC = Eigen::Vector3d::Zero();          ///< m/s, in W.
  Eigen::Vector3d w_WC_C = Eigen::Vector3d::Zero();        ///< rad/s, in C.
  double exposure_s = 0.004;
  double defocus_px = 0.0;
  int noise_level = 0;      ///< Index of the noise level of the camera.
  double contrast = 1.0;    ///< Factor applied to gray levels.
  double brightness = 0.0;  ///< Gray level added after that, of 255.

  /// Pose `offset_s` after mid-exposure.
  Eigen::Isometry3d PoseAt(double offset_s) const;
};

/// Draws a view with `target` at a random position in the image and the camera outside all solid objects.
View DrawView(const ViewConfig& config, const sim::Scene& scene, const GroundShape& target,
              const models::CameraModel& camera, models::RandomStream& random);

/// Motion of the target in the image during the exposure, px; 0 when the target cannot be projected.
double MotionBlur(const View& view, const GroundShape& target, const models::CameraModel& camera);

}  // namespace touchdown::training
