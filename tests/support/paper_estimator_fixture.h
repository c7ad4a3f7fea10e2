#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <utility>

#include "estimator/paper/paper_estimator.h"
#include "models/random_stream.h"
#include "models/vehicle.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::tests {

inline constexpr models::Tick kFrame = 20;

/// Estimator that receives consecutive synthetic frames of the pad.
class PaperEstimatorFixture : public testing::Test {
 protected:
  /// X_WB with the camera at `p_WC`. The arguments are those of CameraAbovePad.
  Eigen::Isometry3d BodyWithCameraAt(const Eigen::Vector3d& p_WC, double yaw = 0.0, double tilt = 0.0,
                                     double direction = 0.0) const {
    return CameraAbovePad(p_WC, yaw, tilt, direction) * setup_.X_BC.inverse();
  }

  models::Image Render(const Eigen::Isometry3d& X_WB, const PadAppearance& appearance = {.noise_sigma = 3.0}) {
    return RenderPad(setup_.camera, setup_.pad, X_WB * setup_.X_BC, appearance, &random_);
  }

  estimator::FrameResult EstimateView(const Eigen::Isometry3d& X_WB,
                                      const PadAppearance& appearance = {.noise_sigma = 3.0}) {
    return estimator_->Estimate(Render(X_WB, appearance).View(), tick_ += kFrame, GravityIn(X_WB));
  }

  estimator::FrameResult EstimateImage(const models::Image& image, const Eigen::Isometry3d& X_WB) {
    return estimator_->Estimate(image.View(), tick_ += kFrame, GravityIn(X_WB));
  }

  estimator::EstimatorSetup setup_{.camera = {}, .pad = {}, .X_BC = models::Vehicle().X_BC(), .time = {}};
  models::RandomStream random_{1, "tests.paper_estimator"};
  std::unique_ptr<estimator::paper::PaperEstimator> estimator_ =
      std::make_unique<estimator::paper::PaperEstimator>(setup_);
  models::Tick tick_ = 0;
};

}  // namespace touchdown::tests
