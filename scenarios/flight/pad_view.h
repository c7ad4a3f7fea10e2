#pragma once

#include <Eigen/Geometry>

#include "models/camera_model.h"
#include "models/landing_pad.h"

namespace touchdown::scenarios {

/// Whether every point of the ring's outer boundary is in the image of a camera at X_WC, distortion included.
bool WholeRingInView(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC);

/// A body's pose, or its twin: the pad looks the same from a pose turned by 180 degrees about W's Z axis
/// (Sec. IV-C.3). The one whose yaw is nearer to `yaw` is returned.
Eigen::Isometry3d NearerTwin(const Eigen::Isometry3d& X_WB, double yaw);

}  // namespace touchdown::scenarios
