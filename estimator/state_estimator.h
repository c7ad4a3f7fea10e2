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

  /// Adds the next IMU sample, a mean since the one before. `at_rest`: the vehicle stands on the ground, motors off.
  virtual void AddImu(const models::ImuSample& sample, bool at_rest) = 0;

  /// Adds the collective thrust commanded from `tick` on, over the vehicle's assumed mass, m/s^2: the specific force
  /// along body Z that the rotors alone would cause. Optional input: without it no disturbance is reported.
  virtual void AddCommand(models::Tick tick, double specific_thrust_m_s2) = 0;

  /// Adds the next camera frame, in the order of exposure, and returns what was found in it. A frame arrives late: IMU
  /// samples after its mid-exposure may have been added before. `image` has the camera's size and a stride of at least
  /// its width (throws std::invalid_argument otherwise).
  virtual FrameResult AddFrame(const models::ImageView& image, models::Tick mid_exposure) = 0;

  /// The state at `tick`, which must not lie before the newest IMU sample; nullopt before the first sample.
  virtual std::optional<models::VehicleEstimate> StateAt(models::Tick tick) const = 0;

  /// Forgets all samples, commands and frames: the state is as after construction.
  virtual void Reset() = 0;
};

}  // namespace touchdown::estimator
