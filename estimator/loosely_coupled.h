#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "estimator/attitude_estimator.h"
#include "estimator/pose_filter.h"
#include "estimator/state_estimator.h"
#include "estimator/vision_estimator.h"

namespace touchdown::estimator {

/// The filters around the vision part of a loosely coupled strategy.
struct LooselyCoupledConfig {
  AttitudeEstimatorConfig attitude;
  PoseFilterConfig pose_filter;
};

/// The state as Sec. V estimates it: roll, pitch and rates from the IMU, position, velocity and yaw from the poses of a
/// VisionEstimator.
///
/// A frame is judged by gravity at its mid-exposure; before the first IMU sample, without gravity. Of the two poses
/// that the 180-degree yaw ambiguity leaves (models::ResolveYawAmbiguity) the filters use the one nearer to the present
/// yaw; the frame's result is as vision gives it. A frame whose status is not ok leaves the filters unchanged.
///
/// The covariance of yaw is that of the newest pose used, an upper bound of its white part. The disturbance is the
/// newest sample's specific force, without the estimated bias, minus the thrust that was commanded before it.
class LooselyCoupled final : public StateEstimator {
 public:
  /// `vision` must not be null; `R_BU` is the calibrated mounting of the IMU. Throws InputError for an invalid config.
  LooselyCoupled(std::unique_ptr<VisionEstimator> vision, const LooselyCoupledConfig& config,
                 const models::TimeBase& time, const Eigen::Matrix3d& R_BU);

  void AddImu(const models::ImuSample& sample, bool at_rest) override;
  void AddCommand(models::Tick tick, double specific_thrust_m_s2) override;
  FrameResult AddFrame(const models::ImageView& image, models::Tick mid_exposure) override;
  std::optional<models::VehicleEstimate> StateAt(models::Tick tick) const override;
  void Reset() override;

 private:
  /// All that changes.
  struct Memory {
    AttitudeEstimator attitude;
    PoseFilter filter;
    bool has_imu = false;
    bool pad_tracked = false;
    double yaw_variance_rad2 = 0.0;  ///< Of the newest pose used.
    std::optional<double> specific_thrust_m_s2 = std::nullopt;
    std::optional<Eigen::Vector3d> disturbance_B_m_s2 = std::nullopt;
  };
  Memory Fresh() const;
  std::optional<Eigen::Matrix<double, 9, 9>> CovarianceAt(models::Tick tick) const;

  std::unique_ptr<VisionEstimator> vision_;
  LooselyCoupledConfig config_;
  models::TimeBase time_;
  Eigen::Matrix3d R_BU_;
  Memory memory_;
};

}  // namespace touchdown::estimator
