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

/// A room in which nothing moves but the camera that is placed for each frame, and the estimator that looks at the
/// frames: the experiments that need no flight. A scenario's true camera takes the frames, what is assumed of camera
/// and mounting is told the estimator.
class StillRoom {
 public:
  /// As in a flight.
  static constexpr std::array<double, 1> kFlightNoise{3.0};

  /// `noise_sigmas`, of 255, are what View::noise_level chooses from; `seed` is the noise's. `told` must outlive the
  /// room.
  StillRoom(const runner::Scenario& nominal, const sim::Scene& scene, std::uint64_t seed,
            std::span<const double> noise_sigmas = kFlightNoise);

  models::Image Take(const training::View& view) { return camera_.Take(view); }
  /// Another frame of the view taken last, from which its noise alone tells it.
  models::Image TakeAgain() { return camera_.TakeAgain(); }

  /// What the estimator finds in a frame, with `gravity_B`, the unit vector pointing down in the body, as its IMU
  /// measures it at rest. Each frame is the first that the estimator is given.
  estimator::FrameResult Estimate(const models::Image& image, const Eigen::Vector3d& gravity_B);

 private:
  training::SceneCamera camera_;
  Eigen::Matrix3d R_BU_;  // As assumed.
  std::unique_ptr<estimator::StateEstimator> estimator_;
};

/// The unit vector pointing down, in the body.
Eigen::Vector3d DownIn(const Eigen::Isometry3d& X_WB);

}  // namespace touchdown::experiments
