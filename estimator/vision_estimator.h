#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/frame_result.h"
#include "models/signals.h"

namespace touchdown::estimator {

/// Turns single camera frames into poses: the vision part of a loosely coupled strategy. Camera, pad and mounting are
/// given at construction. It may remember earlier frames.
class VisionEstimator {
 public:
  virtual ~VisionEstimator() = default;

  /// `image` has the camera's size and a stride of at least its width (throws std::invalid_argument otherwise).
  /// `gravity_B` is the unit vector pointing down, in the body frame at mid-exposure, as the IMU has it; nullopt
  /// without an IMU. Frames come in the order of their exposure.
  virtual FrameResult Estimate(const models::ImageView& image, models::Tick mid_exposure,
                               const std::optional<Eigen::Vector3d>& gravity_B) = 0;

  /// Forgets earlier frames.
  virtual void Reset() = 0;
};

}  // namespace touchdown::estimator
