#pragma once

#include <vector>

#include "estimator/state_estimator.h"
#include "scenarios/flight/flight_observer.h"
#include "scenarios/flight/scenario.h"

namespace touchdown::scenarios {

/// A second estimator that is given the same frames and IMU samples as the one that flies, and flies nothing: two
/// settings side by side.
class ShadowEstimator final : public FlightObserver {
 public:
  /// `estimator` in place of the scenario's.
  ShadowEstimator(const Scenario& scenario, const estimator::EstimatorConfig& estimator);

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameEstimate& estimate,
               const FrameRecord& record) override;

  /// The flight's frames with what this estimator made of them. Without wall-clock times.
  const std::vector<FrameRecord>& frames() const { return frames_; }

 private:
  estimator::StateEstimator estimator_;
  std::vector<FrameRecord> frames_;
};

}  // namespace touchdown::scenarios
