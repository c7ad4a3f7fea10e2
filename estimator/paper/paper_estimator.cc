#include "estimator/paper/paper_estimator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "estimator/paper/pad_pose.h"
#include "estimator/paper/print_misfit.h"
#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator {
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

Vector2d CenterOf(const Component& component) {
  return {component.u + 0.5 * (component.width - 1), component.v + 0.5 * (component.height - 1)};
}

PixelBox BoxOf(const Component& c) { return {c.u, c.v, c.width, c.height}; }

FrameTrace::Ellipse Traced(const Ellipse& ellipse) { return {ellipse.center, ellipse.semi_axes, ellipse.angle}; }

/// From pixels to normalized coordinates: x_px = K x.
Eigen::Matrix3d CameraMatrix(const models::CameraModel& camera) {
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = camera.fx_px;
  K(1, 1) = camera.fy_px;
  K(0, 2) = camera.cx_px;
  K(1, 2) = camera.cy_px;
  return K;
}

std::vector<Vector2d> Normalized(std::span<const Vector2d> pixels, const models::CameraModel& camera) {
  std::vector<Vector2d> normalized;
  normalized.reserve(pixels.size());
  for (const Vector2d& pixel : pixels) normalized.push_back(camera.NormalizedFromPixel(pixel));
  return normalized;
}

Eigen::Matrix3d NormalizedConic(const Ellipse& ellipse, const models::CameraModel& camera) {
  const Eigen::Matrix3d K = CameraMatrix(camera);
  return K.transpose() * ellipse.Conic() * K;
}

}  // namespace

void PaperEstimatorConfig::Validate() const {
  binarize.Validate();
  components.Validate();
  pad_detector.Validate();
  edges.Validate();
  outlier_gate.Validate();
  covariance.Validate();
  if (!std::isfinite(largest_ring_rms_px) || largest_ring_rms_px <= 0.0) {
    throw InputError("the largest distance of ring points from their ellipse must be positive and finite");
  }
}

ComponentClassifier PaperEstimator::NetworkClassifier() {
  return [](const ComponentSet& set, const Component& component) { return Classify(set, component); };
}

PaperEstimator::PaperEstimator(const EstimatorSetup& setup, const PaperEstimatorConfig& config,
                               ComponentClassifier classify)
    : setup_(setup),
      config_(Validated(config)),
      undistort_(Validated(setup.camera)),
      detector_(setup.pad, std::move(classify), config.pad_detector),
      letter_(setup.pad),
      gate_(config.outlier_gate, setup.time, setup.frame_order) {}

FrameEstimate PaperEstimator::Estimate(const models::ImageView& image, models::Tick mid_exposure,
                                       const std::optional<Eigen::Vector3d>& gravity_B) {
  if (image.data == nullptr || image.width != setup_.camera.width_px || image.height != setup_.camera.height_px) {
    throw std::invalid_argument("the image has another size than the camera");
  }
  if (image.stride < image.width)
    throw std::invalid_argument("the image's rows overlap: its stride is below its width");
  FrameEstimate estimate;
  estimate.mid_exposure = mid_exposure;

  const models::Image dark = Binarize(image, config_.binarize);
  const ComponentSet components = ExtractComponents(dark.View(), config_.components);
  PadDetector::Result detection = detector_.Detect(components);
  estimate.trace.components = std::move(detection.labelled);
  if (const auto* failed = std::get_if<FrameStatus>(&detection.outcome)) {
    estimate.status = *failed;
    return estimate;
  }
  const DetectedPad& detected = std::get<DetectedPad>(detection.outcome);
  estimate.pad_px = CenterOf(detected.letter);
  estimate.ring_box = BoxOf(detected.ring);
  estimate.status = FrameStatus::kNoEllipse;

  const auto ellipses = FitPad(image, components, detected);
  if (!ellipses) return estimate;
  estimate.trace.ring_outer = Traced(ellipses->ring_outer);
  if (ellipses->ring_inner) estimate.trace.ring_inner = Traced(*ellipses->ring_inner);
  estimate.trace.letter = Traced(ellipses->letter);

  const auto ring_poses = BothPoses(ellipses->ring_outer);
  if (!ring_poses) return estimate;
  const Branch branch = gravity_B ? BranchByGravity(*ring_poses, *gravity_B) : BranchByPrint(*ellipses, *ring_poses);
  const CirclePose& ring_pose = (*ring_poses)[branch.chosen];
  const Eigen::Isometry3d X_WB = BodyPoseFrom(ring_pose, ellipses->stroke_angle);
  const auto covariance = Covariance(*ellipses, *ring_poses, branch);
  if (!covariance) return estimate;
  estimate.choice = branch.choice;
  if (const auto center = setup_.camera.Project(ring_pose.p_CW)) estimate.pad_px = *center;
  estimate.pose = VisionPose{X_WB, *covariance};
  estimate.status = gate_.Accepts(mid_exposure, X_WB) ? FrameStatus::kOk : FrameStatus::kOutlier;
  return estimate;
}

std::optional<PaperEstimator::PadEllipses> PaperEstimator::FitPad(const models::ImageView& image,
                                                                  const ComponentSet& components,
                                                                  const DetectedPad& detected) const {
  PadContours contours = FindContours(image, components, detected, setup_.pad, config_.edges);
  for (auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
    for (Vector2d& point : *contour) point = undistort_.At(point);
  }
  const auto ring_outer = FitEllipse(contours.ring_outer);
  const auto letter = FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const auto normalized_letter = Ellipse::FromConic(NormalizedConic(*letter, setup_.camera));
  if (!normalized_letter) return std::nullopt;
  if (RmsDistance(*ring_outer, contours.ring_outer) > config_.largest_ring_rms_px) return std::nullopt;
  return PadEllipses{*ring_outer, FitEllipse(contours.ring_inner), *letter, letter_.StrokeAngle(*normalized_letter),
                     std::move(contours)};
}

std::optional<std::array<CirclePose, 2>> PaperEstimator::BothPoses(const Ellipse& ring) const {
  return PosesOfCircle(NormalizedConic(ring, setup_.camera), setup_.pad.outer_radius_m);
}

PaperEstimator::Branch PaperEstimator::BranchByGravity(const std::array<CirclePose, 2>& ring_poses,
                                                       const Eigen::Vector3d& gravity_B) const {
  const Eigen::Vector3d z_C = ReferenceNormal(gravity_B, setup_.X_BC.linear());
  const std::size_t chosen = ResolveByGravity(ring_poses, z_C);
  return {.chosen = chosen,
          .choice = {PoseChoice::Reason::kGravity, models::AngleBetween(ring_poses[chosen].n_C, z_C),
                     models::AngleBetween(ring_poses[1 - chosen].n_C, z_C)},
          .wrong_probability = WrongBranchProbability(ring_poses, z_C, config_.covariance.gravity_sigma_rad),
          .vertical_C = z_C};
}

/// The paper always has an IMU. Without one, what is printed within the ring tells the poses apart, unless it fits both
/// alike.
PaperEstimator::Branch PaperEstimator::BranchByPrint(const PadEllipses& ellipses,
                                                     const std::array<CirclePose, 2>& ring_poses) const {
  constexpr double kUndecided = 0.1;
  const std::vector<Vector2d> ring_inner = Normalized(ellipses.contours.ring_inner, setup_.camera),
                              letter = Normalized(ellipses.contours.letter, setup_.camera);
  std::array<PrintMisfit, 2> misfits;
  for (std::size_t i = 0; i < 2; ++i) misfits[i] = MisfitOfPrint(ring_inner, letter, setup_.pad, ring_poses[i]);
  std::size_t chosen = misfits[0].rms_m <= misfits[1].rms_m ? 0 : 1;
  const double wrong = ProbabilityOfLargerMisfit(misfits[chosen], misfits[1 - chosen]);
  PoseChoice choice{PoseChoice::Reason::kPrint, misfits[chosen].rms_m, misfits[1 - chosen].rms_m};
  if (wrong > kUndecided) {
    const Eigen::Vector3d frontal = -Eigen::Vector3d::UnitZ();
    chosen = ResolveByGravity(ring_poses, frontal);
    choice = {PoseChoice::Reason::kFrontal, models::AngleBetween(ring_poses[chosen].n_C, frontal),
              models::AngleBetween(ring_poses[1 - chosen].n_C, frontal)};
  }
  return {.chosen = chosen, .choice = choice, .wrong_probability = wrong, .vertical_C = ring_poses[chosen].n_C};
}

Eigen::Isometry3d PaperEstimator::BodyPoseFrom(const CirclePose& ring_pose, double stroke_angle) const {
  const double psi_C = CameraYaw(stroke_angle, setup_.X_BC.linear());
  return BodyPose(CameraRotation(ring_pose.n_C, psi_C), ring_pose.p_CW, setup_.X_BC);
}

std::optional<Eigen::Matrix<double, 6, 6>> PaperEstimator::Covariance(const PadEllipses& ellipses,
                                                                      const std::array<CirclePose, 2>& ring_poses,
                                                                      const Branch& branch) const {
  const Eigen::Isometry3d X_WB = BodyPoseFrom(ring_poses[branch.chosen], ellipses.stroke_angle);
  const auto ring_covariance = EllipseCovariance(ellipses.ring_outer, ellipses.contours.ring_outer, config_.covariance);
  if (!ring_covariance) return std::nullopt;

  const double edge_sigma_px = RmsDistance(ellipses.ring_outer, ellipses.contours.ring_outer);
  const auto seen_at_pose = letter_.StrokeAngleSeenFrom((X_WB * setup_.X_BC).inverse());
  const double not_rectified =
      models::WrapToHalfPi(seen_at_pose.value_or(ellipses.stroke_angle) - ellipses.stroke_angle);
  const double stroke_sigma =
      StrokeSigma(ellipses.letter, ellipses.contours.letter.size(), edge_sigma_px, not_rectified, config_.covariance);

  const auto pose_of = [&](const Ellipse& ring, double stroke_angle) -> std::optional<Eigen::Isometry3d> {
    const auto poses = BothPoses(ring);
    if (!poses) return std::nullopt;
    return BodyPoseFrom((*poses)[ResolveByGravity(*poses, branch.vertical_C)], stroke_angle);
  };
  const Eigen::Isometry3d other_X_WB = BodyPoseFrom(ring_poses[1 - branch.chosen], ellipses.stroke_angle);
  auto covariance = PoseCovariance(ellipses.ring_outer, *ring_covariance, ellipses.stroke_angle, stroke_sigma, X_WB,
                                   pose_of, config_.covariance);
  if (covariance) *covariance += WrongBranchCovariance(X_WB, other_X_WB, branch.wrong_probability);
  return covariance;
}

}  // namespace touchdown::estimator
