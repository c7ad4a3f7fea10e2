#include "scenarios/datasets/estimate_footage.h"

#include <fmt/format.h>

#include "estimator/make_estimator.h"
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

/// Gives an estimator the IMU's samples in the order in which a vehicle has samples and frames.
class ImuFeed {
 public:
  ImuFeed(const FootageSetup& setup, const FootageFacts& facts) : readings_(setup.imu), latency_(facts.latency) {}

  /// Adds the samples that come before a frame is delivered.
  void AddBefore(models::Tick mid_exposure, estimator::StateEstimator& estimator) {
    const models::Tick end = latency_ ? mid_exposure + *latency_ : mid_exposure + 1;
    for (; next_ < readings_.size() && readings_[next_].sample.tick < end; ++next_) {
      estimator.AddImu(readings_[next_].sample, readings_[next_].at_rest);
    }
  }

 private:
  const std::vector<ImuReading>& readings_;
  std::optional<models::Tick> latency_;
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
  const auto estimator = estimator::MakeEstimator(setup.estimator, {.camera = setup.camera,
                                                                    .pad = setup.pad,
                                                                    .X_BC = mounting.X_BC,
                                                                    .R_BU = mounting.X_BU.linear(),
                                                                    .time = facts.time,
                                                                    .frame_order = facts.frame_order});
  ImuFeed imu(setup, facts);

  std::vector<FootageEstimate> estimates;
  while (const auto frame = footage.Next()) {
    RequireCameraSize(*frame, setup.camera);
    if (!setup.imu.empty()) imu.AddBefore(TimeOf(*frame), *estimator);
    const auto place = static_cast<models::Tick>(estimates.size());
    FootageEstimate estimate{frame->source, frame->mid_exposure,
                             estimator->AddFrame(frame->image.View(), frame->mid_exposure.value_or(place))};
    if (!setup.mounting && estimate.seen.pose) estimate.seen.pose->X_WB = estimate.seen.pose->X_WB * mounting.X_BC;
    if (observer) observer(*frame, estimate);
    estimates.push_back(std::move(estimate));
    estimates.back().seen.overlay.boxes.clear();
  }
  return estimates;
}

}  // namespace touchdown::datasets
