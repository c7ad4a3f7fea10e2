#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "models/camera_model.h"
#include "models/describe.h"
#include "models/signals.h"
#include "models/time.h"
#include "sim/dynamics/true_state.h"
#include "sim/dynamics/world.h"
#include "sim/sensors/imager.h"

namespace touchdown::sim {

struct CameraConfig {
  models::CameraModel model;
  int rate_hz = 60;
  double noise_sigma = 3.0;
  double exposure_ms = 4.0;
  double latency_ms = 20.0;
  double vibration_rad_s2_m = 0.002;  // In a hover, a blur of a few tenths of a pixel (Sec. VI-B.2).

  double exposure_s() const { return exposure_ms / 1000.0; }
  double latency_s() const { return latency_ms / 1000.0; }

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the camera model is
  /// not valid, the rate does not divide the ticks, or exposure, latency and rate contradict each other.
  void Validate(const models::TimeBase& time) const;
};

void Describe(models::ConfigVisitor& v, CameraConfig& config);

/// The downward camera: renders at mid-exposure, blurs over the exposure, distorts, adds noise, delivers with latency.
class Camera {
 public:
  /// Throws InputError when the config is not valid. `world` must outlive the camera.
  Camera(const CameraConfig& config, const Eigen::Isometry3d& X_BC, World& world, const models::TimeBase& time,
         std::uint64_t seed);

  /// Call at every tick from 0, with the state of that tick. Returns the frame that is delivered at this tick, or
  /// nullopt. Exposures are centered on the ticks that the frame period divides; before tick 0 the camera is assumed to
  /// be at rest. Throws std::logic_error for a skipped tick.
  std::optional<models::CameraFrame> Sample(const TrueState& truth);

  /// Pose of the camera in W at a true state. The vibration of the rotors tilts the compliant mount: the lens lags
  /// behind the acceleration and rotates about the optical center.
  Eigen::Isometry3d X_WC(const TrueState& truth) const;

  /// Wall-clock cost of the newest frame's rendering and image effects, ms. For timing.json only.
  double render_ms() const { return render_ms_; }

 private:
  struct Delivery {
    models::Tick due = 0;
    models::CameraFrame frame;
  };

  void StorePose(const TrueState& truth);
  Eigen::Isometry3d PoseAt(double ticks_ago) const;
  std::vector<Eigen::Isometry3d> ExposedPath() const;
  models::CameraFrame Expose(models::Tick mid_exposure);

  CameraConfig config_;
  Eigen::Isometry3d X_BC_;
  World& world_;
  models::Tick period_;
  models::Tick latency_;
  double half_exposure_;  ///< In ticks, with a fractional part.
  models::Tick reach_;    ///< Ticks from mid-exposure to the first one at which the shutter has closed.
  Imager imager_;
  std::optional<models::Tick> newest_;
  std::deque<Eigen::Isometry3d> poses_;  ///< X_WC of the latest ticks, the newest last.
  std::deque<Delivery> pending_;
  double render_ms_ = 0.0;
};

}  // namespace touchdown::sim
