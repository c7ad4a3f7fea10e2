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

/// Observer that draws up to 12 annotated frames of a flight, evenly spaced over the flight, into one image. It stores
/// fewer than 48 frames, whatever the flight duration. It annotates the frames only when Png() is called, so that its
/// cost during a flight is at most one frame copy per frame.
class ContactSheet final : public runner::FlightObserver {
 public:
  ContactSheet(const models::CameraModel& camera, const models::TimeBase& time);

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
               const runner::FrameRecord& record) override;

  /// The image as PNG, with four frames per row; nullopt when there were no frames. Throws std::runtime_error when
  /// OpenCV cannot encode it.
  std::optional<std::string> Png() const;

 private:
  struct StoredFrame {
    models::Image image;
    estimator::Overlay overlay;
    runner::FrameRecord record;
  };

  std::vector<std::size_t> Selection() const;
  cv::Mat Tile(const StoredFrame& frame) const;

  models::CameraModel camera_;
  models::TimeBase time_;
  cv::Size tile_;
  std::vector<StoredFrame> stored_;
  std::size_t stride_ = 1;  ///< Every stride-th frame is stored.
  std::size_t count_ = 0;
};

}  // namespace touchdown::report
