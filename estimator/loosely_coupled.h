#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "estimator/attitude_estimator.h"
#include "estimator/pose_filter.h"
#include "estimator/state_estimator.h"
#include "estimator/vision_estimator.h"

namespace touchdown::estimator {

/// Settings of the filters of a loosely coupled strategy.
struct LooselyCoupledConfig {
  AttitudeEstimatorConfig attitude;
  PoseFilterConfig pose_filter;
};

/// Estimates the state as in Sec. V: roll, pitch and rates from the IMU; position, velocity and yaw from the poses of a
/// VisionEstimator.
///
/// The VisionEstimator receives the gravity direction at the frame's mid-exposure, or none before the first IMU sample.
/// The 180-degree yaw ambiguity allows two poses (models::ResolveYawAmbiguity); the filters use the one nearer to the
/// current yaw, and the returned FrameResult has the pose from vision. A frame whose status is not ok leaves the
/// filters unchanged.
///
/// The yaw variance is that of the newest pose used, an upper bound of its white noise. The disturbance is the newest
/// sample's specific force, without the estimated bias, minus the thrust that was commanded before the sample.
class LooselyCoupled final : public StateEstimator {
 public:
  /// `vision` must not be null; `R_BU` is the calibrated orientation of the IMU in the body frame. Throws InputError
  /// for an invalid config.
  LooselyCoupled(std::unique_ptr<VisionEstimator> vision, const LooselyCoupledConfig& config,
                 const models::TimeBase& time, const Eigen::Matrix3d& R_BU);

  void AddImu(const models::ImuSample& sample, bool at_rest) override;
  void AddCommand(models::Tick tick, double specific_thrust_m_s2) override;
  FrameResult AddFrame(const models::ImageView& image, models::Tick mid_exposure) override;
  std::optional<models::VehicleEstimate> StateAt(models::Tick tick) const override;
  void Reset() override;

 private:
  /// Everything that Reset restores.
  struct State {
    AttitudeEstimator attitude;
    PoseFilter filter;
    bool has_imu = false;
    bool pad_tracked = false;
    double yaw_variance_rad2 = 0.0;  ///< Variance of the newest pose used.
    std::optional<double> specific_thrust_m_s2 = std::nullopt;
    std::optional<Eigen::Vector3d> disturbance_B_m_s2 = std::nullopt;
  };
  State InitialState() const;
  std::optional<Eigen::Matrix<double, 9, 9>> CovarianceAt(models::Tick tick) const;

  std::unique_ptr<VisionEstimator> vision_;
  LooselyCoupledConfig config_;
  models::TimeBase time_;
  Eigen::Matrix3d R_BU_;
  State state_;
};

}  // namespace touchdown::estimator
