#include "scenarios/experiments/shadow_estimator.h"

namespace touchdown::experiments {

ShadowEstimator::ShadowEstimator(const runner::Scenario& s, const estimator::EstimatorConfig& estimator)
    : estimator_(estimator::MakeEstimator(estimator, {.camera = s.assumed_camera(),
                                                      .pad = s.pad,
                                                      .X_BC = s.assumed_vehicle().X_BC(),
                                                      .R_BU = s.assumed_vehicle().X_BU().linear(),
                                                      .time = s.time})) {}

void ShadowEstimator::OnImu(const models::ImuSample& sample, bool at_rest) { estimator_->AddImu(sample, at_rest); }

void ShadowEstimator::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& /*estimate*/,
                              const runner::FrameRecord& record) {
  const estimator::FrameResult result = estimator_->AddFrame(frame.image.View(), frame.mid_exposure);
  runner::FrameRecord own = record;
  own.status = result.status;
  own.reason = result.reason;
  own.pose = result.pose;
  own.pad_px = result.pad_px;
  own.render_ms = own.vision_ms = own.geometry_ms = 0.0;
  frames_.push_back(own);
}

}  // namespace touchdown::experiments
