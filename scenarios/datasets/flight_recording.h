#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {

/// Returns whether FlightRecording writes a file with this path, relative to the directory of the recording.
bool IsFlightRecordingFile(const std::filesystem::path& file);

/// Records a flight in the EuRoC layout, which EurocFolder reads. The directory mav0 contains the frames as PNG files
/// (cam0), the IMU samples and the changes of the at-rest signal (imu0), and the true pose X_WB
/// (state_groundtruth_estimate0). Next to mav0 are scenario.yaml with the resolved scenario, camera.yaml with the
/// assumed camera model in ROS format, and pad.yaml. The time of a frame is its mid-exposure.
class FlightRecording final : public runner::FlightObserver {
 public:
  /// Creates the directory `folder`. All members throw InputError when a file cannot be written.
  FlightRecording(const runner::Scenario& scenario, const std::filesystem::path& folder);

  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Writes all other files; OnFrame has already written the frames.
  void Finish(const runner::FlightLog& log);

 private:
  void Write(const std::filesystem::path& name, const std::string& content) const;

  runner::Scenario scenario_;
  std::filesystem::path folder_;
  std::string frames_csv_, imu_csv_, at_rest_csv_;
  bool at_rest_ = false;
};

}  // namespace touchdown::datasets
