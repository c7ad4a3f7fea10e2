#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// A flight's time 0 in its bag: ROS knows no time before 0, and means "unknown" by 0.
inline constexpr std::int64_t kBagEpoch_ns = 1'000'000'000'000;

/// Topics that tell of a flight what the estimator was told, for BagFile: std_msgs/String with the resolved scenario,
/// and std_msgs/Bool whenever it changes whether the vehicle knew that it stood on the ground, motors off.
inline constexpr const char* kScenarioTopic = "/touchdown/scenario";
inline constexpr const char* kAtRestTopic = "/touchdown/at_rest";

/// Writes a flight into a ROS 1 bag while it is flown; docs/scenarios.md lists its topics. A message's stamp is the
/// time of what it tells, to the nanosecond, kBagEpoch_ns later than in the flight; it is recorded when the vehicle had
/// it (frames and what was seen in them: when they were delivered), the truth at its own time. The same flight gives
/// the same bytes.
///
/// Chunks are not compressed: LZ4 takes half a percent off frames with the default noise.
class FlightBag final : public runner::FlightObserver {
 public:
  /// The file is made. Throws InputError, as every other member does, when it cannot be written, or when this build
  /// knows no bags: one line that names it.
  FlightBag(const runner::Scenario& scenario, const std::filesystem::path& file);
  /// Removes the file unless it is finished.
  ~FlightBag() override;
  FlightBag(const FlightBag&) = delete;
  FlightBag& operator=(const FlightBag&) = delete;

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Writes the truth and the tracking system's poses, and completes the file.
  void Finish(const runner::FlightLog& log);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::datasets
