#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// Whether `file`, relative to a recording, is one of those that FlightRecording writes.
bool IsOfFlightRecording(const std::filesystem::path& file);

/// Records a flight while it is flown, in the layout that EurocFolder reads: mav0 with the camera's frames as PNG
/// (cam0), the IMU's samples and the times at which the vehicle knew that it was at rest (imu0), and the truth
/// (state_groundtruth_estimate0: position and rotation of the body in W); beside it scenario.yaml as resolved,
/// camera.yaml as ROS has it, and pad.yaml. A frame's time is its mid-exposure.
class FlightRecording final : public runner::FlightObserver {
 public:
  /// `folder` is made. Throws InputError when it cannot be written, as every other member does.
  FlightRecording(const runner::Scenario& scenario, const std::filesystem::path& folder);

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Writes all but the frames, which are written as they come.
  void Finish(const runner::FlightLog& log);

 private:
  void Write(const std::filesystem::path& name, const std::string& content) const;

  runner::Scenario scenario_;
  std::filesystem::path folder_;
  std::string frames_csv_, imu_csv_, at_rest_csv_;
  bool at_rest_ = false;
};

}  // namespace touchdown::datasets
