#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "estimator/estimator.h"
#include "models/camera_model.h"
#include "models/signals.h"
#include "scenarios/flight/flight_log.h"
#include "scenarios/flight/flight_observer.h"

namespace touchdown::scenarios {

/// A frame in colour with what the estimator saw in it, in the paper's colours (Sec. IV-A, Fig. 2 and 5): components'
/// boxes green for circles, blue for letters H and red for others, the fitted ellipses, an orange cross on the pad, and
/// a line with time, phase and status.
cv::Mat AnnotateFrame(const models::ImageView& image, const models::CameraModel& camera,
                      const estimator::FrameTrace& trace, const FrameRecord& record, double time_s);

/// Some annotated frames, evenly spread over a flight of unknown length, on one picture. It keeps fewer than 48 frames,
/// however long the flight, and draws them when asked for the picture: during a flight it costs a copy of a frame.
class ContactSheet final : public FlightObserver {
 public:
  ContactSheet(const models::CameraModel& camera, const models::TimeBase& time);

  void OnFrame(const models::CameraFrame& frame, const estimator::FrameEstimate& estimate,
               const FrameRecord& record) override;

  /// The picture as PNG, four frames a row; nullopt when there were no frames. Throws std::runtime_error when it cannot
  /// be encoded.
  std::optional<std::string> Png() const;

 private:
  struct Kept {
    models::Image image;
    estimator::FrameTrace trace;
    FrameRecord record;
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

}  // namespace touchdown::scenarios
