#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/frame_result.h"
#include "models/signals.h"

namespace touchdown::estimator {

/// Estimates poses from single camera frames: the vision part of a loosely coupled strategy. Camera, pad and mounting
/// are set at construction. An implementation may keep information from earlier frames.
class VisionEstimator {
 public:
  virtual ~VisionEstimator() = default;

  /// Estimates the body's pose from a frame. Frames must come in order of exposure. `image` must have the camera's size
  /// and a stride of at least its width; throws std::invalid_argument otherwise. `gravity_B` is the IMU's estimate of
  /// the unit vector pointing down, in the body frame at mid-exposure; nullopt without an IMU.
  virtual FrameResult Estimate(const models::ImageView& image, models::Tick mid_exposure,
                               const std::optional<Eigen::Vector3d>& gravity_B) = 0;

  /// Discards information from earlier frames.
  virtual void Reset() = 0;
};

}  // namespace touchdown::estimator
