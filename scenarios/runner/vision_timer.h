#pragma once

#include <functional>
#include <optional>

#include "estimator/estimator_setup.h"
#include "scenarios/util/stopwatch.h"

namespace touchdown::runner {

/// Wall-clock times of the estimation of a frame.
struct VisionTime {
  double total_ms = 0.0;
  double geometry_ms = 0.0;  ///< Portion of total_ms spent in FrameStage::kGeometry.
};

/// Measures the wall-clock time of an estimator per frame and stage.
class VisionTimer {
 public:
  /// Listener for EstimatorSetup::on_stage. The timer must outlive the estimator.
  std::function<void(estimator::FrameStage)> listener() {
    return [this](estimator::FrameStage stage) { Enter(stage); };
  }

  void Start() {
    time_ = {};
    geometry_.reset();
    whole_ = util::Stopwatch();
  }

  VisionTime Stop() {
    Enter(estimator::FrameStage::kRecognition);
    time_.total_ms = whole_.milliseconds();
    return time_;
  }

 private:
  void Enter(estimator::FrameStage stage) {
    if (geometry_) time_.geometry_ms += geometry_->milliseconds();
    geometry_.reset();
    if (stage == estimator::FrameStage::kGeometry) geometry_.emplace();
  }

  VisionTime time_;
  util::Stopwatch whole_;
  std::optional<util::Stopwatch> geometry_;
};

}  // namespace touchdown::runner
