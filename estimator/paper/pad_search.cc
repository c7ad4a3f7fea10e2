#include "estimator/paper/pad_search.h"

#include <algorithm>
#include <utility>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;

/// Longest side for which the settings are tuned. A larger image is first downsampled by an integer factor.
constexpr int kNominalSide_px = 960;

int ReductionOf(const models::CameraModel& camera) {
  const auto [shorter, longer] = std::minmax(camera.width_px, camera.height_px);
  return std::clamp((longer + kNominalSide_px - 1) / kNominalSide_px, 1, shorter);
}

PixelBox BoxOf(const Component& c) { return {c.u, c.v, c.width, c.height}; }

}  // namespace

void PadSearchConfig::Validate() const {
  binarize.Validate();
  components.Validate();
  pad_detector.Validate();
  edges.Validate();
  ring_fit.Validate();
  template_matcher.Validate();
  ellipse_detection.Validate();
}

PadSearch::PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
                     FrameOrder frame_order, const PadSearchConfig& config, std::function<void(FrameStage)> on_stage)
    : camera_(camera),
      pad_(pad),
      config_(config),
      undistort_(camera),
      letter_(pad),
      detector_(pad, std::move(classify), config.pad_detector),
      searches_edges_(frame_order != FrameOrder::kFlight && config.verify == Verify::kTemplate),
      on_stage_(std::move(on_stage)),
      reduction_(ReductionOf(camera)) {
  if (config.verify == Verify::kTemplate) {
    template_.emplace(camera, pad,
                      pad::TemplateSearchConfig{.edges = config.edges,
                                                .ring_fit = config.ring_fit,
                                                .template_matcher = config.template_matcher,
                                                .ellipse_detection = config.ellipse_detection});
  } else if (!letter_.HasDirection()) {
    throw InputError(
        "estimator.paper.verify is none; allowed only for a pad whose letter is clearly higher than wide or wider than "
        "high");
  }
}

PadSearch::Result PadSearch::Find(const models::ImageView& image) const {
  Enter(FrameStage::kRecognition);
  const auto downsampled = reduction_ > 1 ? std::optional(pad::Downsampled(image, reduction_)) : std::nullopt;
  const pad::DownsampledImage nominal{downsampled ? downsampled->View() : image, {camera_, undistort_, reduction_}};
  Result result = FindByComponents(nominal);
  if (result.pad || !searches_edges_) return result;
  Enter(FrameStage::kRecognition);
  result.pad = FindByEdges(nominal);
  return result;
}

PadSearch::Result PadSearch::FindByComponents(const pad::DownsampledImage& input) const {
  const models::Image dark = Binarize(input.image, config_.binarize);
  const ComponentSet components = ExtractComponents(dark.View(), config_.components);
  PadDetector::Result detection = detector_.Detect(components);
  Result result{.pad = std::nullopt, .failed = Reason::kNoEllipse, .labeled = std::move(detection.labeled)};
  for (LabeledComponent& each : result.labeled) each.box = pad::Scaled(each.box, input.view.reduction);
  if (const auto* failed = std::get_if<Reason>(&detection.outcome)) {
    result.failed = *failed;
    return result;
  }
  Enter(FrameStage::kGeometry);
  for (const DetectedPad& candidate : std::get<std::vector<DetectedPad>>(detection.outcome)) {
    if ((result.pad = Fit(input, components, candidate))) break;
  }
  return result;
}

std::optional<pad::FoundPad> PadSearch::Fit(const pad::DownsampledImage& input, const ComponentSet& components,
                                            const DetectedPad& detected) const {
  pad::PadContours contours = FindContours(input.image, components, detected, pad_, config_.edges);
  pad::Undistort(input.view, contours);
  const auto ring_outer = pad::FitRing(contours.ring_outer, config_.ring_fit);
  const auto letter = pad::FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const auto ring_poses = pad::PosesOfCircle(pad::NormalizedConic(*ring_outer, camera_), pad_.outer_radius_m);
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(*letter, camera_));
  if (!ring_poses || !normalized_letter) return std::nullopt;
  const bool is_the_letter =
      !template_ || std::any_of(ring_poses->begin(), ring_poses->end(), [&](const pad::CirclePose& pose) {
        return TemplateMatches(*normalized_letter, input, pose);
      });
  // Otherwise the component is not the letter alone, or not the whole letter.
  if (!is_the_letter) {
    return WithLetterDirection(template_->FindWithinRing(input, input, BoxOf(detected.ring), *ring_poses));
  }
  const auto ring_inner = pad::FitEllipse(contours.ring_inner);
  return pad::FoundPad{.ring_outer = *ring_outer,
                       .ring_inner = ring_inner,
                       .letter = *letter,
                       .stroke_angle = letter_.StrokeAngle(*normalized_letter),
                       .contours = std::move(contours),
                       .ring_box = pad::Scaled(BoxOf(detected.ring), input.view.reduction),
                       .ring_poses = *ring_poses};
}

/// Whether the template matches on the plane of `ring_pose` in the direction of the letter's ellipse.
bool PadSearch::TemplateMatches(const pad::Ellipse& normalized_letter, const pad::DownsampledImage& input,
                                const pad::CirclePose& ring_pose) const {
  if (!letter_.HasDirection()) return false;
  const pad::PadPlane plane(ring_pose, input.view);
  std::vector<Vector2d> on_plane;
  for (const Vector2d& point : pad::PointsOn(normalized_letter)) on_plane.push_back(plane.PointFromNormalized(point));
  const auto letter = pad::FitEllipse(on_plane);
  if (!letter) return false;
  std::vector<pad::TemplateWarp> warps(1);
  warps[0].angle = letter_.StrokeAngle(*letter);
  if (!pad_.marks.empty()) warps.emplace_back().angle = warps[0].angle + models::kPi;
  return template_->template_matcher().MatchesAt(input.image, plane, warps);
}

std::optional<pad::FoundPad> PadSearch::FindByEdges(const pad::DownsampledImage& nominal) const {
  // The coarse image first: it has less blur and noise, and fewer pixels to search.
  constexpr int kCoarse = 2;
  std::optional<pad::FoundPad> found;
  if (std::min(nominal.image.width, nominal.image.height) >= kCoarse) {
    const models::Image coarse = pad::Downsampled(nominal.image, kCoarse);
    found = template_->FindByEdges({coarse.View(), {camera_, undistort_, kCoarse * reduction_}}, nominal);
  }
  if (!found) found = template_->FindByEdges(nominal, nominal);
  return WithLetterDirection(std::move(found));
}

/// The pad with the direction of the strokes from the letter's ellipse, as in Sec. IV-C.3, if the ellipse has a
/// direction.
std::optional<pad::FoundPad> PadSearch::WithLetterDirection(std::optional<pad::FoundPad> pad) const {
  if (!pad || !letter_.HasDirection()) return pad;
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(pad->letter, camera_));
  if (normalized_letter) pad->stroke_angle = letter_.StrokeAngle(*normalized_letter);
  return pad;
}

}  // namespace touchdown::estimator::paper
