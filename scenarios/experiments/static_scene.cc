#include "scenarios/experiments/static_scene.h"

#include "sim/render/camera_optics.h"

namespace touchdown::experiments {

SingleFrameEstimator::SingleFrameEstimator(const runner::Scenario& scenario)
    : R_BU_(scenario.assumed_vehicle().X_BU().linear()),
      estimator_(estimator::MakeEstimator(scenario.estimator, {.camera = scenario.assumed_camera(),
                                                               .pad = scenario.pad,
                                                               .X_BC = scenario.assumed_vehicle().X_BC(),
                                                               .R_BU = R_BU_,
                                                               .time = scenario.time})) {}

estimator::FrameResult SingleFrameEstimator::Estimate(const models::Image& image, const Eigen::Vector3d& gravity_B) {
  estimator_->Reset();
  estimator_->AddImu({.specific_force_U = -models::kGravity_m_s2 * (R_BU_.transpose() * gravity_B)}, false);
  return estimator_->AddFrame(image.View(), 0);
}

StaticScene::StaticScene(const runner::Scenario& nominal, const sim::Scene& scene, std::uint64_t seed,
                         std::span<const double> noise_sigmas)
    : camera_(scene, sim::CameraOptics(nominal.camera.model), noise_sigmas, seed), estimator_(nominal) {}

Eigen::Vector3d DownInBody(const Eigen::Isometry3d& X_WB) {
  return -X_WB.linear().transpose() * Eigen::Vector3d::UnitZ();
}

}  // namespace touchdown::experiments
