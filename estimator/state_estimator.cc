#include "estimator/state_estimator.h"

#include <utility>

#include "models/angles.h"
#include "models/landing_pad.h"

namespace touchdown::estimator {

StateEstimator::StateEstimator(std::unique_ptr<Estimator> vision, const Config& config, const models::TimeBase& time,
                               const Eigen::Matrix3d& R_BU)
    : vision_(std::move(vision)), attitude_(config.attitude, time, R_BU), filter_(config.filter, time) {}

void StateEstimator::TakeImu(const models::ImuSample& imu, bool at_rest) { attitude_.Update(imu, at_rest); }

FrameEstimate StateEstimator::TakeFrame(const models::ImageView& image, models::Tick mid_exposure) {
  FrameEstimate seen = vision_->Estimate(image, mid_exposure, attitude_.GravityAt(mid_exposure));
  if (seen.status == FrameStatus::kOk) {
    const Eigen::Isometry3d X_WB = models::NearerTwin(seen.pose.value().X_WB, attitude_.attitude().yaw);
    filter_.Update(mid_exposure, X_WB.translation());
    attitude_.CorrectYaw(mid_exposure, models::TaitBryanFromRotation(X_WB.linear()).yaw);
  }
  return seen;
}

models::VehicleEstimate StateEstimator::At(models::Tick tick) const {
  return {.tick = tick,
          .attitude = attitude_.attitude(),
          .w_WB_B = attitude_.w_WB_B(),
          .motion = filter_.At(tick),
          .pad_seen = filter_.newest()};
}

}  // namespace touchdown::estimator
