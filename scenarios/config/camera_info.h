#pragma once

#include <string>

#include "models/camera_model.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// Whether the root of a file is a ROS `camera_info` calibration and not the keys of `camera` or `camera.model`.
bool IsCameraInfo(const ConfigNode& root);

/// Converts a `camera_info` calibration to the keys of `camera.model`. Unknown keys are errors, as
/// in a scenario. Throws InputError with place and key for a layout that differs from that of ROS, a distortion model
/// other than plumb_bob, a camera matrix with skew, or the rectification or projection of a stereo camera.
ConfigNode CameraModelFromCameraInfo(const ConfigNode& root);

/// ROS `camera_info` YAML of a camera model; LoadCameraModel reads back identical values.
std::string CameraInfoYaml(const models::CameraModel& model, const std::string& camera_name);

}  // namespace touchdown::config
