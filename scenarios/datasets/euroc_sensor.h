#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "models/camera_model.h"

namespace touchdown::datasets {

/// Contents of a camera's sensor.yaml.
struct EurocCamera {
  models::CameraModel model;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
};

/// Reads the sensor.yaml of a camera and ignores unknown keys. Throws InputError, naming file, line and key, for a
/// missing or invalid value, and for a distortion model other than radial-tangential.
EurocCamera ReadEurocCamera(const std::filesystem::path& file);

/// Reads T_BS, the sensor's pose in the body frame, from a sensor.yaml. Throws InputError as ReadEurocCamera does.
Eigen::Isometry3d ReadEurocMounting(const std::filesystem::path& file);

/// Content of the sensor.yaml of a camera and of an IMU. The functions above read back bit-identical values.
std::string EurocCameraYaml(const EurocCamera& camera, int rate_hz);
std::string EurocImuYaml(const Eigen::Isometry3d& X_BU, int rate_hz, double gyro_noise_rad_s_sqrt_hz,
                         double accelerometer_noise_m_s2_sqrt_hz);

}  // namespace touchdown::datasets
