#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>

#include "models/describe.h"
#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::sim {

/// Parameters of the external tracking system (Sec. III-C): noise of a few millimeters and about a degree, and
/// occlusions of its markers that cause outliers or gaps (Sec. VI-B.1).
struct TrackingSystemConfig {
  int rate_hz = 100;
  double position_noise_m = 0.002;
  double rotation_noise_deg = 0.5;
  double occlusions_per_s = 0.05;
  double occlusion_duration_s = 0.2;
  double outlier_probability = 0.5;
  double outlier_position_m = 0.15;
  double outlier_rotation_deg = 11.5;

  /// Throws InputError for a value out of its range (see Describe), or when the rate does not divide `time`'s or there
  /// are more occlusions than poses.
  void Validate(const models::TimeBase& time) const;
};

void Describe(models::ConfigVisitor& v, TrackingSystemConfig& config);

/// Simulated tracking system, with white noise on position and rotation. The time to the next occlusion and the
/// duration of an occlusion are exponentially distributed.
class TrackingSystem {
 public:
  using Config = TrackingSystemConfig;
  using Reading = models::TrackedPose;
  static constexpr const char* kName = "tracking";
  static constexpr const char* kDoc = "External tracking system, whose poses are written to tracking.csv.";
  static constexpr const char* kColumns = "x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg";
  static std::array<double, 6> Columns(const Reading& reading);

  /// Draws noise from the stream "tracking.noise" and occlusions from "tracking.occlusion".
  TrackingSystem(const TrackingSystemConfig& config, const models::TimeBase& time, std::uint64_t seed);

  /// Call once per tick, in order; returns a pose on the ticks of its rate, unless the markers are occluded.
  std::optional<models::TrackedPose> Sample(const TrueState& truth);

 private:
  struct Occlusion {
    double begin_s = 0.0;
    double end_s = 0.0;
    bool gap = false;
    Eigen::Vector3d position_offset = Eigen::Vector3d::Zero();  ///< In W.
    Eigen::Vector3d rotation_offset = Eigen::Vector3d::Zero();  ///< Rotation vector in B.
  };

  std::optional<Occlusion> OcclusionAfter(double time_s);

  TrackingSystemConfig config_;
  models::TimeBase time_;
  models::Tick period_;
  models::RandomStream noise_;
  models::RandomStream occlusion_random_;
  std::optional<Occlusion> next_;  ///< Current or next occlusion; nullopt when there are none.
};

}  // namespace touchdown::sim
