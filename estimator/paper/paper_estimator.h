#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "estimator/estimator_setup.h"
#include "estimator/pad/conic_pose.h"
#include "estimator/pad/outlier_gate.h"
#include "estimator/pad/pose_covariance.h"
#include "estimator/paper/letter_ellipse.h"
#include "estimator/paper/pad_search.h"
#include "estimator/vision_estimator.h"

namespace touchdown::estimator::paper {

/// Settings of every step. The defaults are the values used in flight.
struct PaperEstimatorConfig {
  PadSearchConfig search;
  pad::OutlierGateConfig outlier_gate;
  pad::PoseCovarianceConfig covariance;

  /// Throws InputError when a setting is invalid.
  void Validate() const;
};

/// Estimates the pose with the method of Yang et al. (Sec. IV).
class PaperEstimator final : public VisionEstimator {
 public:
  /// Classifies components with the compiled-in network for the pad's letter (Sec. IV-A.3). Throws InputError when the
  /// camera, the pad or a setting is invalid.
  explicit PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config = {});

  /// Same as above, but classifies components with `classify`, for tests.
  PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config, ComponentClassifier classify);

  FrameResult Estimate(const models::ImageView& image, models::Tick mid_exposure,
                       const std::optional<Eigen::Vector3d>& gravity_B) override;
  void Reset() override;

 private:
  /// Choice between the two pose hypotheses of a circle.
  struct Branch {
    std::size_t chosen;
    PoseChoice choice;
    double wrong_probability;
    Eigen::Vector3d vertical_C;  // Vertical from the IMU, or else the normal of the chosen pose.
  };

  Branch BranchByGravity(const std::array<pad::CirclePose, 2>& ring_poses, const Eigen::Vector3d& gravity_B) const;
  Branch BranchByTemplate(const pad::FoundPad& pad) const;
  std::optional<std::array<pad::CirclePose, 2>> PoseHypotheses(const pad::Ellipse& ring) const;
  Eigen::Isometry3d BodyPoseFrom(const pad::CirclePose& ring_pose, double stroke_angle) const;
  std::optional<Eigen::Matrix<double, 6, 6>> Covariance(const pad::FoundPad& pad, const Branch& branch) const;

  EstimatorSetup setup_;
  PaperEstimatorConfig config_;
  PadSearch search_;
  LetterEllipse letter_;
  pad::OutlierGate gate_;
};

}  // namespace touchdown::estimator::paper
