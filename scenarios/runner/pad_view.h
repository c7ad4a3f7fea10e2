#pragma once

#include <Eigen/Geometry>

#include "models/camera_model.h"
#include "models/landing_pad.h"

namespace touchdown::runner {

/// Whether every point of the ring's outer boundary is in the image of a camera at X_WC, with lens
/// distortion.
bool WholeRingInView(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC);

}  // namespace touchdown::runner
