#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/angles.h"
#include "models/time.h"
#include "models/vehicle.h"

namespace touchdown::models {

/// View of an 8-bit gray image. `stride` is in bytes, from a row to the next.
struct ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  const std::uint8_t* Row(int v) const { return data + v * stride; }
  std::uint8_t At(int u, int v) const { return Row(v)[u]; }
};

/// An 8-bit gray image without padding between rows.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  Image() = default;
  Image(int width_px, int height_px, std::uint8_t value = 0)
      : width(width_px),
        height(height_px),
        pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), value) {}

  ImageView View() const { return {pixels.data(), width, height, width}; }
  std::uint8_t* Row(int v) { return pixels.data() + static_cast<std::ptrdiff_t>(v) * width; }
};

/// Frame of the camera with its time.
struct CameraFrame {
  Tick mid_exposure = 0;
  Image image;
};

/// Sample of the IMU, in its frame U.
struct ImuSample {
  Tick tick = 0;
  Eigen::Vector3d specific_force_U = Eigen::Vector3d::Zero();  ///< m/s^2; +g along up at rest.
  Eigen::Vector3d w_WU_U = Eigen::Vector3d::Zero();            ///< rad/s.
};

/// Pose of the body from the tracking system (Sec. III-C).
struct TrackedPose {
  Tick tick = 0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// Reading of the downward range finder.
struct RangeReading {
  Tick tick = 0;
  double range_m = 0.0;  ///< Distance along -Z of B.
};

/// Estimated state of the vehicle, the input of the controller.
struct VehicleEstimate {
  struct Motion {
    Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< m.
    Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  ///< m/s.
  };

  Tick tick = 0;
  TaitBryan attitude = {};  ///< Roll and pitch from the IMU; yaw from vision, propagated by the gyro.
  Eigen::Vector3d w_WB_B = Eigen::Vector3d::Zero();  ///< rad/s.
  std::optional<Motion> motion = std::nullopt;       ///< nullopt before the first vision pose.
  /// Covariance of the estimation error, as the estimator computes it, of (p_WB in m, rotation vector in W in rad, v_WB
  /// in m/s); set whenever `motion` is set.
  std::optional<Eigen::Matrix<double, 9, 9>> covariance = std::nullopt;
  std::optional<Tick> pad_seen = std::nullopt;  ///< Mid-exposure of the newest frame whose pose was used.
  bool pad_tracked = false;                     ///< True if the pose of the newest frame was used.
  /// Disturbance force over mass: measured specific force minus commanded thrust over mass, in B. On the ground it
  /// includes the ground's reaction. nullopt when the estimator does not estimate it or has received no command.
  std::optional<Eigen::Vector3d> disturbance_B_m_s2 = std::nullopt;
};

/// Commanded rotor speeds in rad/s; 0 stops a motor.
struct RotorCommand {
  std::array<double, kRotorCount> speed_rad_s{};
};

}  // namespace touchdown::models
