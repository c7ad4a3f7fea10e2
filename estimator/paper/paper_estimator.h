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

/// The settings of every step, with the values that the flights are flown with.
struct PaperEstimatorConfig {
  PadSearchConfig search;
  pad::OutlierGateConfig outlier_gate;
  pad::PoseCovarianceConfig covariance;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// The paper's method (Sec. IV), a step after the other.
class PaperEstimator final : public VisionEstimator {
 public:
  /// Components are labeled by the compiled-in network of the pad's letter (Sec. IV-A.3). Throws InputError when the
  /// camera, the pad or a setting is impossible.
  explicit PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config = {});

  /// The same, but `classify` labels the components, as where a test brings the truth.
  PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config, ComponentClassifier classify);

  FrameResult Estimate(const models::ImageView& image, models::Tick mid_exposure,
                       const std::optional<Eigen::Vector3d>& gravity_B) override;
  void Reset() override;

 private:
  /// Which of the two poses of a circle is taken.
  struct Branch {
    std::size_t chosen;
    PoseChoice choice;
    double wrong_probability;
    Eigen::Vector3d vertical_C;  // Near which the pose's normal lies: the IMU's, or else the chosen pose's own.
  };

  Branch BranchByGravity(const std::array<pad::CirclePose, 2>& ring_poses, const Eigen::Vector3d& gravity_B) const;
  Branch BranchByPrint(const pad::FoundPad& pad) const;
  std::optional<std::array<pad::CirclePose, 2>> BothPoses(const pad::Ellipse& ring) const;
  Eigen::Isometry3d BodyPoseFrom(const pad::CirclePose& ring_pose, double stroke_angle) const;
  std::optional<Eigen::Matrix<double, 6, 6>> Covariance(const pad::FoundPad& pad, const Branch& branch) const;

  EstimatorSetup setup_;
  PaperEstimatorConfig config_;
  PadSearch search_;
  LetterEllipse letter_;
  pad::OutlierGate gate_;
};

}  // namespace touchdown::estimator::paper
