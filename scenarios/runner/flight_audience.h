#pragma once

#include <span>

#include "scenarios/runner/flight_observer.h"

namespace touchdown::runner {

using FlightObservers = std::span<FlightObserver* const>;

/// Forwards to several observers and measures the wall-clock time that they use.
class FlightAudience final : public FlightObserver {
 public:
  explicit FlightAudience(FlightObservers observers) : observers_(observers) {}

  void OnStart(const sim::World& world) override;
  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const FrameRecord& record) override;

  /// Wall-clock time of the observers, s.
  double seconds() const { return seconds_; }

 private:
  template <typename Notify>
  void NotifyAll(const Notify& notify);

  FlightObservers observers_;
  double seconds_ = 0.0;
};

}  // namespace touchdown::runner
