#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "models/camera_model.h"

namespace touchdown::experiments {

/// Lower bound on the 1-sigma errors of any unbiased estimator.
struct CircleLimit {
  double position_m = 0.0;  ///< Position of the camera in W, root sum of squares of the three axes, m.
  double tilt_rad = 0.0;    ///< Direction of the vertical, root sum of squares of both axes, rad.
};

/// Cramer-Rao bound of a camera pose from the image of a circle's edge alone. The circle is a dark disc of radius
/// `radius_m` around W's origin in the ground plane. The camera is at X_WC, and its heading is known. The pixel noise
/// is white and Gaussian; `noise_fraction` is its 1-sigma divided by the gray value step of the edge. Each pixel is the
/// mean over its square area, so a displacement of an edge of length l px by d px across itself changes the sum of
/// squares of the pixels by l d^2 squared steps.
///
/// Returns nullopt when the circle is not completely projected, or when the information matrix is singular: in a
/// frontal view, a tilt moves the edge in the same way as a translation.
std::optional<CircleLimit> LimitForCircle(const models::CameraModel& camera, double radius_m,
                                          const Eigen::Isometry3d& X_WC, double noise_fraction);

}  // namespace touchdown::experiments
