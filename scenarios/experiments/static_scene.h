#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "estimator/make_estimator.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/training/classifier_camera.h"

namespace touchdown::experiments {

/// Runs the estimator of a scenario, with the assumed camera and mountings, on single frames of a vehicle at rest.
class SingleFrameEstimator {
 public:
  explicit SingleFrameEstimator(const runner::Scenario& scenario);

  /// Result for a frame, after a reset. `gravity_B` is the unit vector pointing down in B, which the IMU measures at
  /// rest.
  estimator::FrameResult Estimate(const models::Image& image, const Eigen::Vector3d& gravity_B);

 private:
  Eigen::Matrix3d R_BU_;  // Assumed orientation of the IMU.
  std::unique_ptr<estimator::StateEstimator> estimator_;
};

/// Renders single frames of a static scene from given camera poses, and runs the estimator on them, for experiments
/// without a flight. The scenario's true camera renders the frames; the estimator uses the assumed camera model and
/// mountings.
class StaticScene {
 public:
  /// Image noise of a flight, 1-sigma of 255.
  static constexpr std::array<double, 1> kFlightNoise{3.0};

  /// `noise_sigmas` (of 255) are the values that View::noise_level selects from. `seed` is the seed of the image noise.
  StaticScene(const runner::Scenario& nominal, const sim::Scene& scene, std::uint64_t seed,
              std::span<const double> noise_sigmas = kFlightNoise);

  /// Renders a frame.
  models::Image Capture(const training::View& view) { return camera_.Capture(view); }
  /// Renders the last view again, with new image noise.
  models::Image CaptureAgain() { return camera_.CaptureAgain(); }

  /// See SingleFrameEstimator::Estimate.
  estimator::FrameResult Estimate(const models::Image& image, const Eigen::Vector3d& gravity_B) {
    return estimator_.Estimate(image, gravity_B);
  }

 private:
  training::SceneCamera camera_;
  SingleFrameEstimator estimator_;
};

/// Unit vector pointing down, in B.
Eigen::Vector3d DownInBody(const Eigen::Isometry3d& X_WB);

}  // namespace touchdown::experiments
