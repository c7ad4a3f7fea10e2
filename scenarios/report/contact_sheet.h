#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "estimator/frame_result.h"
#include "models/camera_model.h"
#include "models/signals.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/flight_observer.h"

namespace touchdown::report {

/// Some annotated frames, evenly spread over a flight of unknown length, on one picture. It keeps fewer than 48 frames,
/// however long the flight, and draws them when asked for the picture: during a flight it costs a copy of a frame.
class ContactSheet final : public runner::FlightObserver {
 public:
  ContactSheet(const models::CameraModel& camera, const models::TimeBase& time);

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// The picture as PNG, four frames a row; nullopt when there were no frames. Throws std::runtime_error when it cannot
  /// be encoded.
  std::optional<std::string> Png() const;

 private:
  struct Kept {
    models::Image image;
    estimator::Overlay overlay;
    runner::FrameRecord record;
  };

  std::vector<std::size_t> Selection() const;
  cv::Mat Tile(const Kept& kept) const;

  models::CameraModel camera_;
  models::TimeBase time_;
  cv::Size tile_;
  std::vector<Kept> kept_;
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
};

}  // namespace touchdown::report
