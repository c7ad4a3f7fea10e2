#pragma once

#include <memory>
#include <vector>

#include "estimator/make_estimator.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// Second estimator that processes the same frames and IMU samples as the one in the control loop. It is used to
/// compare two settings in one flight.
class ShadowEstimator final : public runner::FlightObserver {
 public:
  /// Uses the configuration `estimator` instead of the scenario's.
  ShadowEstimator(const runner::Scenario& scenario, const estimator::EstimatorConfig& estimator);

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// The frames of the flight with the results of this estimator; wall-clock times are 0.
  const std::vector<runner::FrameRecord>& frames() const { return frames_; }

 private:
  std::unique_ptr<estimator::StateEstimator> estimator_;
  std::vector<runner::FrameRecord> frames_;
};

}  // namespace touchdown::experiments
