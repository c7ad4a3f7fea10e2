#include "scenarios/runner/flight_audience.h"

#include "scenarios/util/stopwatch.h"

namespace touchdown::runner {

template <typename Notify>
void FlightAudience::NotifyAll(const Notify& notify) {
  const util::Stopwatch clock;
  for (FlightObserver* const observer : observers_) notify(*observer);
  seconds_ += clock.seconds();
}

void FlightAudience::OnStart(const sim::World& world) {
  NotifyAll([&](FlightObserver& observer) { observer.OnStart(world); });
}

void FlightAudience::OnImu(const models::ImuSample& sample, bool at_rest) {
  NotifyAll([&](FlightObserver& observer) { observer.OnImu(sample, at_rest); });
}

void FlightAudience::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
                             const FrameRecord& record) {
  NotifyAll([&](FlightObserver& observer) { observer.OnFrame(frame, estimate, record); });
}

}  // namespace touchdown::runner
