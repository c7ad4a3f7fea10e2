#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "models/camera_model.h"

namespace touchdown::experiments {

/// 1-sigma errors that no unbiased estimator can stay below.
struct CircleLimit {
  double position_m = 0.0;  ///< Of the camera in W, in space.
  double tilt_rad = 0.0;    ///< Of the vertical, both directions together.
};

/// The Cramer-Rao limit of a pose from the image of a circle's edge alone: a dark disc of `radius_m` about W's origin,
/// the camera at X_WC with known heading, the pixels' noise white and Gaussian, `noise_share` its 1-sigma over the
/// edge's step in gray values, and the image as sharp as square pixels let it be (each pixel the mean over its area:
/// moving an edge of length l px across itself by d px changes the pixels' squares by l d^2 steps).
///
/// nullopt where the information is singular: seen frontally, a tilt moves the circle's edge as a shift does.
std::optional<CircleLimit> LimitForCircle(const models::CameraModel& camera, double radius_m,
                                          const Eigen::Isometry3d& X_WC, double noise_share);

}  // namespace touchdown::experiments
