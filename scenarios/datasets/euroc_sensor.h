#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "models/camera_model.h"

namespace touchdown::datasets {

/// What EuRoC's cam0/sensor.yaml tells of a camera.
struct EurocCamera {
  models::CameraModel model;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
};

/// Reads a sensor.yaml; keys that it does not need may be there. Throws InputError, naming file, line and key, for what
/// is missing or impossible, and for a distortion other than radial-tangential.
EurocCamera ReadEurocCamera(const std::filesystem::path& file);

/// T_BS of a sensor.yaml: the sensor's pose in the body frame. Throws as ReadEurocCamera does.
Eigen::Isometry3d ReadEurocMounting(const std::filesystem::path& file);

/// The text of a camera's sensor.yaml and of an IMU's, which the functions above read back to the last bit.
std::string EurocCameraYaml(const EurocCamera& camera, int rate_hz);
std::string EurocImuYaml(const Eigen::Isometry3d& X_BU, int rate_hz, double gyro_noise_rad_s_sqrt_hz,
                         double accelerometer_noise_m_s2_sqrt_hz);

}  // namespace touchdown::datasets
