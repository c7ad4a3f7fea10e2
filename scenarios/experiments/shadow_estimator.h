#pragma once

#include <memory>
#include <vector>

#include "estimator/make_estimator.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// A second estimator that is given the same frames and IMU samples as the one that flies, and flies nothing: two
/// settings side by side.
class ShadowEstimator final : public runner::FlightObserver {
 public:
  /// `estimator` in place of the scenario's.
  ShadowEstimator(const runner::Scenario& scenario, const estimator::EstimatorConfig& estimator);

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// The flight's frames with what this estimator made of them. Without wall-clock times.
  const std::vector<runner::FrameRecord>& frames() const { return frames_; }

 private:
  std::unique_ptr<estimator::StateEstimator> estimator_;
  std::vector<runner::FrameRecord> frames_;
};

}  // namespace touchdown::experiments
