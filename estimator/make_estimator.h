#pragma once

#include <memory>
#include <string>
#include <vector>

#include "estimator/estimator.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/time.h"

namespace touchdown::estimator {

/// Where a frame's edge points are taken: on Canny's pixels, or at their sub-pixel place along the gradient. The paper
/// leaves it open.
enum class ContourPoints { kInteger, kSubpixel };

/// What a scenario may say of the estimator.
struct EstimatorConfig {
  std::string name = "paper";
  ContourPoints contour_points = ContourPoints::kSubpixel;
};

/// What every estimator is told of the world.
struct EstimatorSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();  ///< The camera's calibrated mounting.
  models::TimeBase time;
};

/// The names that MakeEstimator knows.
std::vector<std::string> EstimatorNames();

/// Throws InputError for a name that is not among EstimatorNames(); the message lists them.
std::unique_ptr<Estimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup);

}  // namespace touchdown::estimator
