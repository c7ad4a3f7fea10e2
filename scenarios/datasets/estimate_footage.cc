#include "scenarios/datasets/estimate_footage.h"

#include <fmt/format.h>

#include "estimator/make_estimator.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::datasets {
namespace {

/// Mounting for footage without a known one. The body has its origin at the camera, and the camera has its nominal
/// orientation: it looks down, with the top of the image forward.
SensorMounting NominalMounting() {
  SensorMounting mounting;
  mounting.X_BC.linear() = models::Vehicle().X_BC().linear();
  return mounting;
}

/// Passes IMU samples to an estimator in the order in which a vehicle receives samples and frames.
class ImuFeed {
 public:
  ImuFeed(const FootageSetup& setup, const FootageMetadata& metadata)
      : readings_(setup.imu), latency_(metadata.latency) {}

  /// Adds the samples before the delivery of a frame.
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
  throw InputError(fmt::format("{}: image is {} x {} px, but the camera calibration is for {} x {} px", frame.source,
                               frame.image.width, frame.image.height, camera.width_px, camera.height_px));
}

models::Tick RequireTime(const FootageFrame& frame) {
  if (frame.mid_exposure) return *frame.mid_exposure;
  throw InputError(fmt::format("{}: frame has no time; IMU samples require frames with times", frame.source));
}

}  // namespace

std::vector<FootageEstimate> EstimateFootage(Footage& footage, const FootageSetup& setup,
                                             const FootageObserver& observer) {
  const FootageMetadata& metadata = footage.metadata();
  const SensorMounting mounting = setup.mounting.value_or(NominalMounting());
  const auto estimator = estimator::MakeEstimator(setup.estimator, {.camera = setup.camera,
                                                                    .pad = setup.pad,
                                                                    .X_BC = mounting.X_BC,
                                                                    .R_BU = mounting.X_BU.linear(),
                                                                    .time = metadata.time,
                                                                    .frame_order = metadata.frame_order});
  ImuFeed imu(setup, metadata);

  std::vector<FootageEstimate> estimates;
  while (const auto frame = footage.Next()) {
    RequireCameraSize(*frame, setup.camera);
    if (!setup.imu.empty()) imu.AddBefore(RequireTime(*frame), *estimator);
    const auto index = static_cast<models::Tick>(estimates.size());
    FootageEstimate estimate{frame->source, frame->mid_exposure,
                             estimator->AddFrame(frame->image.View(), frame->mid_exposure.value_or(index))};
    if (!setup.mounting && estimate.result.pose)
      estimate.result.pose->X_WB = estimate.result.pose->X_WB * mounting.X_BC;
    if (observer) observer(*frame, estimate);
    estimates.push_back(std::move(estimate));
    estimates.back().result.overlay.boxes.clear();
  }
  return estimates;
}

}  // namespace touchdown::datasets
