#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// Time of a flight's start in its bag, ns. ROS has no negative times, and 0 means "unknown".
inline constexpr std::int64_t kBagEpoch_ns = 1'000'000'000'000;

/// Topics with the estimator inputs of a flight, which BagFile reads: std_msgs/String with the resolved scenario, and
/// std_msgs/Bool at each change of the signal "at rest on the ground, motors off".
inline constexpr const char* kScenarioTopic = "/touchdown/scenario";
inline constexpr const char* kAtRestTopic = "/touchdown/at_rest";

/// Writes a flight into a ROS 1 bag during the flight; docs/scenarios.md lists the topics. The stamp of a message is
/// the time of measurement in the flight plus kBagEpoch_ns, exact to the nanosecond. Its recording time is the time at
/// which the vehicle received it: the delivery time for frames and estimates, the stamp for the truth. The same flight
/// gives the same bytes.
///
/// Chunks are not compressed: LZ4 saves half a percent for frames with the default noise.
class FlightBag final : public runner::FlightObserver {
 public:
  /// Creates the file. All members throw InputError, naming the file, when it cannot be written. The constructor also
  /// throws it when this build has no bag support.
  FlightBag(const runner::Scenario& scenario, const std::filesystem::path& file);
  /// Removes the file unless Finish has completed it.
  ~FlightBag() override;
  FlightBag(const FlightBag&) = delete;
  FlightBag& operator=(const FlightBag&) = delete;

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Writes the truth and the poses of the tracking system, and completes the file.
  void Finish(const runner::FlightLog& log);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::datasets
