#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "models/camera_model.h"
#include "models/signals.h"
#include "sim/world.h"

namespace touchdown::sim {

struct CameraConfig {
  models::CameraModel model;
  int rate_hz = 60;
  double noise_sigma = 3.0;   ///< Of 255, per pixel.
  double exposure_s = 0.004;
  double latency_s = 0.020;   ///< From mid-exposure to delivery; at least half the exposure.
  double vibration_rad_s2_m = 0.0;  ///< Tilt of the camera's mount per m/s^2 of vibration (compliance).

  void Validate(const models::TimeBase& time) const;
};

/// The downward camera: renders at mid-exposure, blurs over the exposure, distorts, adds noise, delivers late.
class Camera {
 public:
  Camera(const CameraConfig& config, const Eigen::Isometry3d& X_BC, World& world, const models::TimeBase& time,
         std::uint64_t seed);
  ~Camera();

  /// Call once a tick, with the state of that tick. Returns the frame that is delivered now, if any.
  std::optional<models::CameraFrame> Sample(const TrueState& truth);

  /// Pose of the camera in W as it is at `truth`, vibration included.
  Eigen::Isometry3d X_WC(const TrueState& truth) const;

  /// Wall-clock cost of the newest frame's rendering and image effects, ms. For timing.json only.
  double render_ms() const;
};

}  // namespace touchdown::sim
