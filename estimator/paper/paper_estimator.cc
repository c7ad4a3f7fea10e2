#include "estimator/paper/paper_estimator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "estimator/pad/template_residual.h"
#include "estimator/paper/pad_pose.h"
#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;

models::CameraModel Validated(const models::CameraModel& camera) {
  camera.Validate();
  return camera;
}

const PaperEstimatorConfig& Validated(const PaperEstimatorConfig& config) {
  config.Validate();
  return config;
}

std::vector<Vector2d> Normalized(std::span<const Vector2d> pixels, const models::CameraModel& camera) {
  std::vector<Vector2d> normalized;
  normalized.reserve(pixels.size());
  for (const Vector2d& pixel : pixels) normalized.push_back(camera.NormalizedFromPixel(pixel));
  return normalized;
}

Overlay::Box OverlayBox(const LabeledComponent& component) {
  const auto role = component.label == ComponentClass::kCircle ? Overlay::Role::kOutline
                    : component.label == ComponentClass::kH    ? Overlay::Role::kMarking
                                                               : Overlay::Role::kOther;
  return {component.box, role, std::string(Name(component.label)), component.probability};
}

Overlay::Ellipse OverlayEllipse(const pad::Ellipse& ellipse, const char* name) {
  return {ellipse.center, ellipse.semi_axes, ellipse.angle, Overlay::Role::kFit, name};
}

}  // namespace

void PaperEstimatorConfig::Validate() const {
  search.Validate();
  outlier_gate.Validate();
  covariance.Validate();
}

PaperEstimator::PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config)
    : PaperEstimator(setup, config, [letter = setup.pad.letter()](const ComponentSet& set, const Component& component) {
        return Classify(set, component, letter);
      }) {}

PaperEstimator::PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config,
                               ComponentClassifier classify)
    : setup_(setup),
      config_(Validated(config)),
      search_(Validated(setup.camera), setup.pad, std::move(classify), setup.frame_order, config.search,
              setup.on_stage),
      letter_(setup.pad),
      gate_(config.outlier_gate, setup.time, setup.frame_order) {}

FrameResult PaperEstimator::Estimate(const models::ImageView& image, models::Tick mid_exposure,
                                     const std::optional<Eigen::Vector3d>& gravity_B) {
  if (image.data == nullptr || image.width != setup_.camera.width_px || image.height != setup_.camera.height_px) {
    throw std::invalid_argument("the image must have the size of the camera");
  }
  if (image.stride < image.width) throw std::invalid_argument("the stride of the image must be at least its width");
  FrameResult result;
  result.mid_exposure = mid_exposure;

  const PadSearch::Result found = search_.Find(image);
  for (const LabeledComponent& component : found.labeled) result.overlay.boxes.push_back(OverlayBox(component));
  if (!found.pad) {
    result.reason = Name(found.failed);
    return result;
  }
  const pad::FoundPad& pad = *found.pad;
  result.overlay.ellipses.push_back(OverlayEllipse(pad.ring_outer, "ring_outer"));
  if (pad.ring_inner) result.overlay.ellipses.push_back(OverlayEllipse(*pad.ring_inner, "ring_inner"));
  result.overlay.ellipses.push_back(OverlayEllipse(pad.letter, "letter"));

  const Branch branch = gravity_B ? BranchByGravity(pad.ring_poses, *gravity_B) : BranchByTemplate(pad);
  const pad::CirclePose& ring_pose = pad.ring_poses[branch.chosen];
  const Eigen::Isometry3d X_WB = BodyPoseFrom(ring_pose, pad.stroke_angle);
  const auto covariance = Covariance(pad, branch);
  if (!covariance) {
    result.reason = Name(Reason::kNoEllipse);
    return result;
  }
  result.choice = branch.choice;
  if (const auto center = setup_.camera.Project(ring_pose.p_CW)) result.pad_px = *center;
  result.ring_box = pad.ring_box;
  result.pose = VisionPose{X_WB, *covariance};
  if (gate_.Accepts(mid_exposure, X_WB)) {
    result.status = FrameStatus::kOk;
  } else {
    result.status = FrameStatus::kRejected;
    result.reason = Name(Reason::kOutlier);
  }
  return result;
}

void PaperEstimator::Reset() { gate_ = pad::OutlierGate(config_.outlier_gate, setup_.time, setup_.frame_order); }

std::optional<std::array<pad::CirclePose, 2>> PaperEstimator::PoseHypotheses(const pad::Ellipse& ring) const {
  return pad::PosesOfCircle(pad::NormalizedConic(ring, setup_.camera), setup_.pad.outer_radius_m);
}

PaperEstimator::Branch PaperEstimator::BranchByGravity(const std::array<pad::CirclePose, 2>& ring_poses,
                                                       const Eigen::Vector3d& gravity_B) const {
  const Eigen::Vector3d z_C = ReferenceNormal(gravity_B, setup_.X_BC.linear());
  const std::size_t chosen = ResolveByGravity(ring_poses, z_C);
  return {.chosen = chosen,
          .choice = {PoseChoice::Reason::kGravity, models::AngleBetween(ring_poses[chosen].n_C, z_C),
                     models::AngleBetween(ring_poses[1 - chosen].n_C, z_C)},
          .wrong_probability = WrongBranchProbability(ring_poses, z_C, config_.covariance.gravity_sigma_rad),
          .vertical_C = z_C};
}

/// Chooses the pose hypothesis without an IMU, which the paper always has: the one at which the artwork within the ring
/// matches better, or the more frontal one if both match equally well.
PaperEstimator::Branch PaperEstimator::BranchByTemplate(const pad::FoundPad& pad) const {
  constexpr double kUndecided = 0.1;
  const std::array<pad::CirclePose, 2>& ring_poses = pad.ring_poses;
  const std::vector<Vector2d> ring_inner = Normalized(pad.contours.ring_inner, setup_.camera),
                              letter = Normalized(pad.contours.letter, setup_.camera);
  std::array<pad::TemplateResidual, 2> residuals;
  for (std::size_t i = 0; i < 2; ++i)
    residuals[i] = pad::ResidualOfTemplate(ring_inner, letter, setup_.pad, ring_poses[i]);
  std::size_t chosen = residuals[0].rms_m <= residuals[1].rms_m ? 0 : 1;
  const double wrong = pad::WrongBranchProbability(residuals[chosen], residuals[1 - chosen]);
  PoseChoice choice{PoseChoice::Reason::kArtwork, residuals[chosen].rms_m, residuals[1 - chosen].rms_m};
  if (wrong > kUndecided) {
    const Eigen::Vector3d frontal = -Eigen::Vector3d::UnitZ();
    chosen = ResolveByGravity(ring_poses, frontal);
    choice = {PoseChoice::Reason::kFrontal, models::AngleBetween(ring_poses[chosen].n_C, frontal),
              models::AngleBetween(ring_poses[1 - chosen].n_C, frontal)};
  }
  return {.chosen = chosen, .choice = choice, .wrong_probability = wrong, .vertical_C = ring_poses[chosen].n_C};
}

Eigen::Isometry3d PaperEstimator::BodyPoseFrom(const pad::CirclePose& ring_pose, double stroke_angle) const {
  const double psi_C = CameraYaw(stroke_angle, setup_.X_BC.linear());
  return BodyPose(CameraRotation(ring_pose.n_C, psi_C), ring_pose.p_CW, setup_.X_BC);
}

std::optional<Eigen::Matrix<double, 6, 6>> PaperEstimator::Covariance(const pad::FoundPad& pad,
                                                                      const Branch& branch) const {
  const std::array<pad::CirclePose, 2>& ring_poses = pad.ring_poses;
  const Eigen::Isometry3d X_WB = BodyPoseFrom(ring_poses[branch.chosen], pad.stroke_angle);
  const auto ring_covariance = pad::EllipseCovariance(pad.ring_outer, pad.contours.ring_outer, config_.covariance);
  if (!ring_covariance) return std::nullopt;

  const double edge_sigma_px = pad::RmsDistance(pad.ring_outer, pad.contours.ring_outer);
  const auto projected_angle = letter_.ProjectedStrokeAngle((X_WB * setup_.X_BC).inverse());
  const double not_rectified = models::WrapToHalfPi(projected_angle.value_or(pad.stroke_angle) - pad.stroke_angle);
  const double stroke_sigma =
      pad::StrokeSigma(pad.letter, pad.contours.letter.size(), edge_sigma_px, not_rectified, config_.covariance);

  const auto pose_of = [&](const pad::Ellipse& ring, double stroke_angle) -> std::optional<Eigen::Isometry3d> {
    const auto poses = PoseHypotheses(ring);
    if (!poses) return std::nullopt;
    return BodyPoseFrom((*poses)[ResolveByGravity(*poses, branch.vertical_C)], stroke_angle);
  };
  const Eigen::Isometry3d other_X_WB = BodyPoseFrom(ring_poses[1 - branch.chosen], pad.stroke_angle);
  auto covariance = pad::PoseCovariance(pad.ring_outer, *ring_covariance, pad.stroke_angle, stroke_sigma, X_WB, pose_of,
                                        config_.covariance);
  if (covariance) *covariance += pad::WrongBranchCovariance(X_WB, other_X_WB, branch.wrong_probability);
  return covariance;
}

}  // namespace touchdown::estimator::paper
