#include "scenarios/datasets/estimate_footage.h"

#include <fmt/format.h>

#include "estimator/make_estimator.h"
#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::datasets {
namespace {

/// Where nobody tells how the sensors are mounted, the body's origin is the camera's, and its axes are those of a
/// vehicle whose camera and IMU are mounted nominally: the camera looks down, the image's up is forward.
SensorMounting NominalMounting() {
  SensorMounting mounting;
  mounting.X_BC.linear() = models::Vehicle().X_BC().linear();
  return mounting;
}

/// Gravity from the IMU's samples, in the order in which a vehicle would have had them and the frames.
class GravityReference {
 public:
  GravityReference(const FootageSetup& setup, const FootageFacts& facts, const Eigen::Matrix3d& R_BU)
      : readings_(setup.imu), latency_(facts.latency), attitude_(setup.attitude_estimator, facts.time, R_BU) {}

  /// nullopt when there is no sample up to then.
  std::optional<Eigen::Vector3d> At(models::Tick mid_exposure) {
    const models::Tick end = latency_ ? mid_exposure + *latency_ : mid_exposure + 1;
    for (; next_ < readings_.size() && readings_[next_].sample.tick < end; ++next_) {
      attitude_.Update(readings_[next_].sample, readings_[next_].at_rest);
    }
    if (next_ == 0) return std::nullopt;
    return attitude_.GravityAt(mid_exposure);
  }

  void TakePose(models::Tick mid_exposure, const Eigen::Isometry3d& X_WB) {
    const Eigen::Isometry3d near = models::NearerTwin(X_WB, attitude_.attitude().yaw);
    attitude_.CorrectYaw(mid_exposure, models::TaitBryanFromRotation(near.linear()).yaw);
  }

 private:
  const std::vector<ImuReading>& readings_;
  std::optional<models::Tick> latency_;
  estimator::AttitudeEstimator attitude_;
  std::size_t next_ = 0;
};

void RequireCameraSize(const FootageFrame& frame, const models::CameraModel& camera) {
  if (frame.image.width == camera.width_px && frame.image.height == camera.height_px) return;
  throw InputError(fmt::format("{}: is {} x {} px, but the camera's calibration is for {} x {} px", frame.source,
                               frame.image.width, frame.image.height, camera.width_px, camera.height_px));
}

models::Tick TimeOf(const FootageFrame& frame) {
  if (frame.mid_exposure) return *frame.mid_exposure;
  throw InputError(fmt::format("{}: has no time at which the IMU's samples could be looked up", frame.source));
}

}  // namespace

std::vector<FootageEstimate> EstimateFootage(Footage& footage, const FootageSetup& setup,
                                             const FootageObserver& observer) {
  const FootageFacts& facts = footage.facts();
  const SensorMounting mounting = setup.mounting.value_or(NominalMounting());
  const auto vision = estimator::MakeEstimator(setup.estimator, {.camera = setup.camera,
                                                                 .pad = setup.pad,
                                                                 .X_BC = mounting.X_BC,
                                                                 .time = facts.time,
                                                                 .frame_order = facts.frame_order});
  GravityReference gravity(setup, facts, mounting.X_BU.linear());

  std::vector<FootageEstimate> estimates;
  while (const auto frame = footage.Next()) {
    RequireCameraSize(*frame, setup.camera);
    std::optional<Eigen::Vector3d> gravity_B;
    if (!setup.imu.empty()) gravity_B = gravity.At(TimeOf(*frame));
    const auto place = static_cast<models::Tick>(estimates.size());
    FootageEstimate estimate{frame->source, frame->mid_exposure,
                             vision->Estimate(frame->image.View(), frame->mid_exposure.value_or(place), gravity_B)};
    if (gravity_B && estimate.seen.status == estimator::FrameStatus::kOk) {
      gravity.TakePose(*frame->mid_exposure, estimate.seen.pose.value().X_WB);
    }
    if (!setup.mounting && estimate.seen.pose) estimate.seen.pose->X_WB = estimate.seen.pose->X_WB * mounting.X_BC;
    if (observer) observer(*frame, estimate);
    estimates.push_back(std::move(estimate));
    estimates.back().seen.trace.components.clear();
  }
  return estimates;
}

}  // namespace touchdown::datasets
