#pragma once

#include <optional>

#include "estimator/frame_result.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::estimator {

/// A strategy that estimates the vehicle's state: IMU samples, camera frames and commanded thrust in, state out.
class StateEstimator {
 public:
  virtual ~StateEstimator() = default;

  /// Adds the next IMU sample, the mean since the previous sample. `at_rest` is true while the vehicle stands on the
  /// ground with its motors off.
  virtual void AddImu(const models::ImuSample& sample, bool at_rest) = 0;

  /// Adds the collective thrust commanded from `tick` on, divided by the vehicle's assumed mass, m/s^2. It is the
  /// specific force along body Z that the rotors alone would cause. The input is optional: without it the estimator
  /// reports no disturbance.
  virtual void AddCommand(models::Tick tick, double specific_thrust_m_s2) = 0;

  /// Adds the next camera frame, in order of exposure, and returns its result. A frame arrives late: IMU samples after
  /// its mid-exposure may have been added before it. `image` must have the camera's size and a stride of at least its
  /// width; throws std::invalid_argument otherwise.
  virtual FrameResult AddFrame(const models::ImageView& image, models::Tick mid_exposure) = 0;

  /// State at `tick`, which must not be earlier than the newest IMU sample; nullopt before the first sample.
  virtual std::optional<models::VehicleEstimate> StateAt(models::Tick tick) const = 0;

  /// Discards all samples, commands and frames. The state is then the same as after construction.
  virtual void Reset() = 0;
};

}  // namespace touchdown::estimator
