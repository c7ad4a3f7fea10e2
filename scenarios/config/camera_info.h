#pragma once

#include <string>

#include "models/camera_model.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// Whether a file's root is a ROS `camera_info` calibration rather than the keys of `camera` or `camera.model`.
bool IsCameraInfo(const ConfigNode& root);

/// Converts a `camera_info` calibration to the keys of `camera.model`. It is read as strictly as a scenario: throws
/// InputError, with place and key, for a layout other than ROS's, a model other than plumb_bob, a skewed matrix, and
/// a rectification or projection of a camera that is one of a pair.
ConfigNode CameraModelFromCameraInfo(const ConfigNode& root);

/// ROS `camera_info` YAML of a camera model; LoadCameraModel reads back the same bits.
std::string CameraInfoYaml(const models::CameraModel& model, const std::string& camera_name);

}  // namespace touchdown::config
