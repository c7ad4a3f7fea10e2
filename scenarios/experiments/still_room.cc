#include "scenarios/experiments/still_room.h"

#include "estimator/make_estimator.h"
#include "sim/render/camera_optics.h"

namespace touchdown::experiments {

StillRoom::StillRoom(const runner::Scenario& told, const sim::Scene& scene, std::uint64_t seed,
                     std::span<const double> noise_sigmas)
    : time_(told.time),
      camera_(scene, sim::CameraOptics(told.camera.model), noise_sigmas, seed),
      estimator_(estimator::MakeEstimator(told.estimator, {.camera = told.assumed_camera(),
                                                           .pad = told.pad,
                                                           .X_BC = told.assumed_vehicle().X_BC(),
                                                           .time = told.time})) {}

estimator::FrameEstimate StillRoom::Estimate(const models::Image& image, const Eigen::Vector3d& gravity_B) {
  return estimator_->Estimate(image.View(), tick_ += time_.ticks_per_s, gravity_B);
}

Eigen::Vector3d DownIn(const Eigen::Isometry3d& X_WB) { return -X_WB.linear().transpose() * Eigen::Vector3d::UnitZ(); }

}  // namespace touchdown::experiments
