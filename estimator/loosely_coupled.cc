#include "estimator/loosely_coupled.h"

#include <utility>

#include "models/angles.h"
#include "models/landing_pad.h"

namespace touchdown::estimator {

LooselyCoupled::LooselyCoupled(std::unique_ptr<VisionEstimator> vision, const LooselyCoupledConfig& config,
                               const models::TimeBase& time, const Eigen::Matrix3d& R_BU)
    : vision_(std::move(vision)), config_(config), time_(time), R_BU_(R_BU), state_(InitialState()) {}

LooselyCoupled::State LooselyCoupled::InitialState() const {
  return {.attitude = AttitudeEstimator(config_.attitude, time_, R_BU_),
          .filter = PoseFilter(config_.pose_filter, time_)};
}

void LooselyCoupled::AddImu(const models::ImuSample& sample, bool at_rest) {
  State& s = state_;
  s.attitude.Update(sample, at_rest);
  s.has_imu = true;
  if (s.specific_thrust_m_s2) {
    s.disturbance_B_m_s2 = R_BU_ * sample.specific_force_U - s.attitude.accelerometer_bias_B() -
                           *s.specific_thrust_m_s2 * Eigen::Vector3d::UnitZ();
  }
}

void LooselyCoupled::AddCommand(models::Tick /*tick*/, double specific_thrust_m_s2) {
  state_.specific_thrust_m_s2 = specific_thrust_m_s2;
}

FrameResult LooselyCoupled::AddFrame(const models::ImageView& image, models::Tick mid_exposure) {
  State& s = state_;
  std::optional<Eigen::Vector3d> gravity_B;
  if (s.has_imu) gravity_B = s.attitude.GravityAt(mid_exposure);
  FrameResult result = vision_->Estimate(image, mid_exposure, gravity_B);
  s.pad_tracked = result.status == FrameStatus::kOk;
  if (s.pad_tracked) {
    const VisionPose& pose = result.pose.value();
    const Eigen::Isometry3d X_WB = models::ResolveYawAmbiguity(pose.X_WB, s.attitude.attitude().yaw);
    s.filter.Update(mid_exposure, X_WB.translation(), pose.covariance.topLeftCorner<3, 3>());
    s.attitude.CorrectYaw(mid_exposure, models::TaitBryanFromRotation(X_WB.linear()).yaw);
    s.yaw_variance_rad2 = pose.covariance(5, 5);
  }
  return result;
}

std::optional<models::VehicleEstimate> LooselyCoupled::StateAt(models::Tick tick) const {
  const State& s = state_;
  if (!s.has_imu) return std::nullopt;
  return models::VehicleEstimate{.tick = tick,
                                 .attitude = s.attitude.attitude(),
                                 .w_WB_B = s.attitude.w_WB_B(),
                                 .motion = s.filter.At(tick),
                                 .covariance = CovarianceAt(tick),
                                 .pad_seen = s.filter.newest(),
                                 .pad_tracked = s.pad_tracked,
                                 .disturbance_B_m_s2 = s.disturbance_B_m_s2};
}

std::optional<Eigen::Matrix<double, 9, 9>> LooselyCoupled::CovarianceAt(models::Tick tick) const {
  const auto motion = state_.filter.CovarianceAt(tick);
  if (!motion) return std::nullopt;
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
  covariance.topLeftCorner<3, 3>() = motion->topLeftCorner<3, 3>();
  covariance.topRightCorner<3, 3>() = motion->topRightCorner<3, 3>();
  covariance.bottomLeftCorner<3, 3>() = motion->bottomLeftCorner<3, 3>();
  covariance.bottomRightCorner<3, 3>() = motion->bottomRightCorner<3, 3>();
  covariance(3, 3) = covariance(4, 4) = state_.attitude.tilt_variance();
  covariance(5, 5) = state_.yaw_variance_rad2;
  return covariance;
}

void LooselyCoupled::Reset() {
  vision_->Reset();
  state_ = InitialState();
}

}  // namespace touchdown::estimator
