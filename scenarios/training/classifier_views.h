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

/// From where, and how well, the training set sees its shapes.
struct ViewConfig {
  double min_distance_m = 0.12;  ///< Distance of the camera from the shape looked at ...
  double max_distance_m = 3.0;   ///< ... drawn evenly on a logarithmic scale.
  double max_tilt_deg = 55.0;
  double hovering_fraction =
      0.35;                    ///< Of views: level, at rest, in focus and along the shape's axes, as in a calm hover.
  double max_speed_m_s = 1.5;  ///< Of the camera during the exposure, when it moves.
  double max_rate_rad_s = 1.0;
  double min_exposure_s = 0.001;
  double max_exposure_s = 0.012;
  double max_defocus_px = 1.5;                      ///< 1-sigma of the lens's blur.
  std::vector<double> noise_sigmas{0.5, 3.0, 7.0};  ///< Of 255. At weak contrast the last is left out.
  double min_contrast = 0.45;                       ///< Of 1, the renderer's own.

  /// Throws InputError when a range is empty or a number is not finite.
  void Validate() const;
};

/// How a frame is taken.
struct View {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();  ///< At mid-exposure.
  Eigen::Vector3d v_WC = Eigen::Vector3d::Zero();          ///< m/s, in W.
  Eigen::Vector3d w_WC_C = Eigen::Vector3d::Zero();        ///< rad/s, in C.
  double exposure_s = 0.004;
  double defocus_px = 0.0;
  int noise_level = 0;      ///< Which of the camera's levels of noise.
  double contrast = 1.0;    ///< The image's gain about 0 ...
  double brightness = 0.0;  ///< ... and what is added to it, of 255.

  /// Pose `offset_s` after mid-exposure.
  Eigen::Isometry3d PoseAt(double offset_s) const;
};

/// A view of `target` somewhere in the image, from outside the scene's solid objects.
View DrawView(const ViewConfig& config, const sim::Scene& scene, const GroundShape& target,
              const models::CameraModel& camera, models::RandomStream& random);

/// How far the target's image moves over the exposure, px; 0 where it is not in front of the camera.
double MotionBlur(const View& view, const GroundShape& target, const models::CameraModel& camera);

}  // namespace touchdown::training
