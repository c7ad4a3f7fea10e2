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

/// A flight as a film, written while it is flown: the onboard camera with what the estimator saw and the pose that it
/// found drawn into it, beside the vehicle from outside, both 480 px high, and below them time, phase, status and the
/// true height.
///
/// The film's time is the flight's: picture k of F a second shows the frame taken at k / F, the vehicle at that moment.
/// F is the camera's rate, or the largest fraction of it that is at most 30. A frame that was lost leaves the last
/// picture standing, to the flight's end.
class FlightVideo final : public runner::FlightObserver {
 public:
  /// The file is made with the first frame.
  FlightVideo(const runner::Scenario& scenario, const std::filesystem::path& file);

  void OnStart(const sim::World& world) override;
  void OnImu(const models::ImuSample& sample, bool at_rest) override;
  /// Throws InputError when the file cannot be written.
  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// Completes the file; there is none when there were no frames. Throws InputError as OnFrame does.
  void Finish();

 private:
  void HoldUntil(models::Tick tick);
  void DrawOnboard(const models::ImageView& image, const estimator::Overlay& overlay,
                   const runner::FrameRecord& record);

  std::filesystem::path file_;
  models::CameraModel camera_;
  models::LandingPad pad_;
  models::Vehicle vehicle_;
  Eigen::Isometry3d X_BC_;  ///< As the estimator is told.
  models::TimeBase time_;
  models::Tick period_;  ///< From picture to picture.
  FrameRate rate_;
  models::Tick newest_ = 0;
  cv::Mat3b picture_;  ///< The last one.
  std::unique_ptr<sim::ChaseView> chase_;
  std::optional<VideoWriter> writer_;
};

}  // namespace touchdown::report
