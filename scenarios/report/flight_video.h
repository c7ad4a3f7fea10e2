#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "models/camera_model.h"
#include "models/time.h"
#include "models/vehicle.h"
#include "scenarios/report/video_writer.h"
#include "scenarios/runner/flight_observer.h"
#include "scenarios/runner/scenario.h"
#include "sim/render/chase_view.h"

namespace touchdown::report {

/// Observer that writes a video of the flight: the frame of the onboard camera, annotated with the overlay of the
/// estimator and the estimated pose, next to a view of the vehicle from outside, both 480 px high. The caption below
/// gives time, phase, status and true height.
///
/// Video time equals flight time: at F frames/s, video frame k shows the camera frame with mid-exposure at k / F s. F
/// is the camera rate divided by the smallest integer for which F is at most 30. The last video frame is repeated where
/// camera frames are missing, and until the end of the flight.
class FlightVideo final : public runner::FlightObserver {
 public:
  /// Stores the settings. The first call of OnFrame creates `file`.
  FlightVideo(const runner::Scenario& scenario, const std::filesystem::path& file);

  void OnStart(const sim::World& world) override;
  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  /// Throws InputError when the file cannot be written.
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Completes the file; no file exists when there were no frames. Throws InputError when the file cannot be written.
  void Finish();

 private:
  void RepeatFrameUntil(models::Tick tick);
  void DrawOnboard(const models::ImageView& image, const estimator::Overlay& overlay,
                   const runner::FrameRecord& record);

  std::filesystem::path file_;
  models::CameraModel camera_;
  models::LandingPad pad_;
  models::Vehicle vehicle_;
  Eigen::Isometry3d X_BC_;  ///< Assumed extrinsics, as the estimator uses them.
  models::TimeBase time_;
  models::Tick period_;  ///< Period of the video frames.
  FrameRate rate_;
  models::Tick last_tick_ = 0;
  cv::Mat3b video_frame_;  ///< The most recent one.
  std::unique_ptr<sim::ChaseView> chase_;
  std::optional<VideoWriter> writer_;
};

}  // namespace touchdown::report
