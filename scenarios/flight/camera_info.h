#pragma once

#include "scenarios/flight/config_node.h"

namespace touchdown::scenarios {

/// Whether a file's root is a ROS `camera_info` calibration rather than the keys of `camera` or `camera.model`.
bool IsCameraInfo(const ConfigNode& root);

/// The keys of `camera.model` that a `camera_info` calibration stands for. It is read as strictly as a scenario: throws
/// InputError, with place and key, for what is not of ROS's layout, a model other than plumb_bob, a skewed matrix, a
/// distortion term beyond k1 and k2 that is not 0, and a rectification or projection of a camera that is one of a pair.
ConfigNode CameraModelFromCameraInfo(const ConfigNode& root);

}  // namespace touchdown::scenarios
