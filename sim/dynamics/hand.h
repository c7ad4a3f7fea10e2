#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "models/describe.h"
#include "models/random_stream.h"
#include "models/time.h"

namespace touchdown::sim {

/// A hand that lifts the vehicle off the pad and moves and tilts it above the pad, motors off (Sec. VI-B.1).
struct HandConfig {
  bool carries = false;
  double duration_s = 45.0;
  double max_height_m = 1.5;
  double max_tilt_deg = 26.0;
  double max_yaw_deg = 40.0;
  double tremor_m = 0.0002;
  double tremor_deg = 0.046;
  double tremor_hz = 9.0;  // Physiological tremor has 8 to 12 Hz.

  /// Throws InputError for a value out of its range (see Describe).
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, HandConfig& config);

/// Pose and velocities of a body.
struct BodyMotion {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();    ///< m/s, in W.
  Eigen::Vector3d w_WB_B = Eigen::Vector3d::Zero();  ///< rad/s, in B.
};

/// Motion of a hand-held vehicle as a function of time, drawn from the stream "hand".
///
/// Height, horizontal position, roll, pitch and yaw each move from one random value to the next with minimum jerk, a
/// model of hand motion (Flash and Hogan, The coordination of arm movements, J. Neuroscience 5(7), 1985). The
/// horizontal range is proportional to the height, so that the pad is in view most of the time.
class Hand {
 public:
  /// Time at rest before the lift, during which the estimator estimates the accelerometer bias.
  static constexpr double kTimeAtRest_s = 2.0;

  /// `X_WB` is the pose on the pad before the lift. Throws InputError when the config is not valid.
  Hand(const HandConfig& config, const Eigen::Isometry3d& X_WB, const models::TimeBase& time, std::uint64_t seed);

  /// Whether the vehicle is still on the ground.
  bool IsOnGround(models::Tick tick) const { return time_.ToSeconds(tick) < kTimeAtRest_s; }
  /// Motion at a tick.
  BodyMotion At(models::Tick tick) const;

 private:
  /// A smooth random function of time: a sequence of minimum-jerk segments.
  class MinimumJerkPath {
   public:
    /// Starts at `start` and passes through random values within `middle` +- `reach`, one of which is `middle` +
    /// `reach` and a later one `middle` - `reach`. Times are in s since the lift.
    MinimumJerkPath(double start, double middle, double reach, double duration_s, models::RandomStream& random);
    double At(double t_s) const;

   private:
    std::vector<double> times_s_;
    std::vector<double> values_;
  };

  Eigen::Isometry3d PoseAt(double t_s) const;

  HandConfig config_;
  models::TimeBase time_;
  Eigen::Isometry3d X_WB_at_rest_;
  std::vector<MinimumJerkPath> paths_;  // Height, roll, pitch, yaw, and X and Y divided by the height.
  std::vector<double> tremor_phases_;   // Along and about X, Y and Z.
};

}  // namespace touchdown::sim
