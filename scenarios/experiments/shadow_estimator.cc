#include "scenarios/experiments/shadow_estimator.h"

#include "estimator/make_estimator.h"

namespace touchdown::experiments {

ShadowEstimator::ShadowEstimator(const runner::Scenario& s, const estimator::EstimatorConfig& estimator)
    : estimator_(estimator::MakeEstimator(
                     estimator,
                     {.camera = s.assumed_camera(), .pad = s.pad, .X_BC = s.assumed_vehicle().X_BC(), .time = s.time}),
                 {.attitude = s.attitude_estimator, .filter = s.pose_filter}, s.time,
                 s.assumed_vehicle().X_BU().linear()) {}

void ShadowEstimator::OnImu(const models::ImuSample& sample, bool at_rest) { estimator_.TakeImu(sample, at_rest); }

void ShadowEstimator::OnFrame(const models::CameraFrame& frame, const estimator::FrameEstimate& /*estimate*/,
                              const runner::FrameRecord& record) {
  const estimator::FrameEstimate seen = estimator_.TakeFrame(frame.image.View(), frame.mid_exposure);
  runner::FrameRecord own = record;
  own.status = seen.status;
  own.pose = seen.pose;
  own.pad_px = seen.pad_px;
  own.render_ms = own.vision_ms = own.geometry_ms = 0.0;
  frames_.push_back(own);
}

}  // namespace touchdown::experiments
