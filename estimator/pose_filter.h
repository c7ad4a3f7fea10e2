#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "models/describe.h"
#include "models/signals.h"

namespace touchdown::estimator {

/// Source of the standard deviation of a vision position.
enum class VisionNoise {
  kHeight,      ///< Proportional to the height.
  kCovariance,  ///< The covariance of the pose.
};

/// Settings of PoseFilter. The acceleration noises are densities of the white noise that models the acceleration.
struct PoseFilterConfig {
  double xy_acceleration_noise_m_s2_sqrt_hz = 0.40;
  double z_acceleration_noise_m_s2_sqrt_hz = 0.30;
  VisionNoise vision_noise = VisionNoise::kCovariance;
  double xy_noise_per_height = 0.020;
  double min_xy_noise_m = 0.003;
  double z_noise_per_height = 0.005;
  double min_z_noise_m = 0.002;
  double initial_speed_m_s = 0.5;

  /// Throws InputError for a value out of its range (see Describe).
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, PoseFilterConfig& config);

/// Kalman filter of the vision position with a constant-velocity model on each axis: the "basic Kalman filter without
/// taking the IMU information into account" of Sec. V.
class PoseFilter {
 public:
  /// Throws InputError for an invalid config.
  PoseFilter(const PoseFilterConfig& config, const models::TimeBase& time);

  /// Adds the position of a frame with status ok, m, at its mid-exposure, and its covariance in W, m^2, of which the
  /// filter uses the diagonal. The first position sets the state. A frame that is not newer than the newest one added
  /// is ignored.
  void Update(models::Tick mid_exposure, const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& covariance);

  /// Position and velocity predicted to `tick`; nullopt before the first update.
  std::optional<models::VehicleEstimate::Motion> At(models::Tick tick) const;

  /// Covariance of (p_WB in m, v_WB in m/s) predicted to `tick`; nullopt before the first update.
  std::optional<Eigen::Matrix<double, 6, 6>> CovarianceAt(models::Tick tick) const;

  /// Mid-exposure of the newest update; nullopt before the first.
  std::optional<models::Tick> newest() const { return newest_; }

 private:
  /// Filter of one coordinate.
  struct Axis {
    Eigen::Vector2d state = Eigen::Vector2d::Zero();  ///< Position, m, and velocity, m/s.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();

    void Start(double position, double position_sigma, double speed_sigma);
    void Predict(double dt_s, double acceleration_density);
    void Correct(double position, double position_sigma);
  };

  Eigen::Vector3d Noise(double height_m, const Eigen::Matrix3d& covariance) const;
  Eigen::Vector3d AccelerationDensity() const;

  PoseFilterConfig config_;
  models::TimeBase time_;
  std::array<Axis, 3> axes_;
  std::optional<models::Tick> newest_;
};

}  // namespace touchdown::estimator
