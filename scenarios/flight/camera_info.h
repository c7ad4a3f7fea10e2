#pragma once

#include "scenarios/flight/config_node.h"

namespace touchdown::scenarios {

/// Whether a file's root is a ROS `camera_info` calibration rather than the keys of `camera` or `camera.model`.
bool IsCameraInfo(const ConfigNode& root);

/// The keys of `camera.model` that a `camera_info` calibration stands for. Throws InputError for a layout that is not
/// ROS's, a model other than plumb_bob, a skewed matrix, or a distortion term beyond k1 and k2 that is not 0.
ConfigNode CameraModelFromCameraInfo(const ConfigNode& root);

}  // namespace touchdown::scenarios
