#include "estimator/paper/pad_search.h"

#include <algorithm>
#include <utility>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;

/// The steps are set for images no wider than this; a larger one is reduced first, by a whole number.
constexpr int kUsualSide_px = 960;

int ReductionOf(const models::CameraModel& camera) {
  const auto [shorter, longer] = std::minmax(camera.width_px, camera.height_px);
  return std::clamp((longer + kUsualSide_px - 1) / kUsualSide_px, 1, shorter);
}

PixelBox BoxOf(const Component& c) { return {c.u, c.v, c.width, c.height}; }

}  // namespace

void PadSearchConfig::Validate() const {
  binarize.Validate();
  components.Validate();
  pad_detector.Validate();
  edges.Validate();
  ring_fit.Validate();
  print_match.Validate();
  ring_search.Validate();
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
                                                .print_match = config.print_match,
                                                .ring_search = config.ring_search});
  } else if (!letter_.HasDirection()) {
    throw InputError("estimator.paper.verify none needs a pad whose H is clearly higher than wide, or wider than high");
  }
}

PadSearch::Result PadSearch::Find(const models::ImageView& image) const {
  Enter(FrameStage::kRecognition);
  const auto shrunk = reduction_ > 1 ? std::optional(pad::Shrunk(image, reduction_)) : std::nullopt;
  const pad::DownsampledImage usual{shrunk ? shrunk->View() : image, {camera_, undistort_, reduction_}};
  Result result = ByComponents(usual);
  if (result.pad || !searches_edges_) return result;
  Enter(FrameStage::kRecognition);
  result.pad = ByEdges(usual);
  return result;
}

PadSearch::Result PadSearch::ByComponents(const pad::DownsampledImage& seen) const {
  const models::Image dark = Binarize(seen.image, config_.binarize);
  const ComponentSet components = ExtractComponents(dark.View(), config_.components);
  PadDetector::Result detection = detector_.Detect(components);
  Result result{.pad = std::nullopt, .failed = Reason::kNoEllipse, .labeled = std::move(detection.labeled)};
  for (LabeledComponent& each : result.labeled) each.box = pad::Scaled(each.box, seen.view.reduction);
  if (const auto* failed = std::get_if<Reason>(&detection.outcome)) {
    result.failed = *failed;
    return result;
  }
  Enter(FrameStage::kGeometry);
  for (const DetectedPad& candidate : std::get<std::vector<DetectedPad>>(detection.outcome)) {
    if ((result.pad = Fit(seen, components, candidate))) break;
  }
  return result;
}

std::optional<pad::FoundPad> PadSearch::Fit(const pad::DownsampledImage& seen, const ComponentSet& components,
                                            const DetectedPad& detected) const {
  pad::PadContours contours = FindContours(seen.image, components, detected, pad_, config_.edges);
  pad::Undistort(seen.view, contours);
  const auto ring_outer = pad::FitRing(contours.ring_outer, config_.ring_fit);
  const auto letter = pad::FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const auto ring_poses = pad::PosesOfCircle(pad::NormalizedConic(*ring_outer, camera_), pad_.outer_radius_m);
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(*letter, camera_));
  if (!ring_poses || !normalized_letter) return std::nullopt;
  const bool is_the_letter =
      !template_ || std::any_of(ring_poses->begin(), ring_poses->end(), [&](const pad::CirclePose& pose) {
        return IsTemplateUnder(*normalized_letter, seen, pose);
      });
  // Else its component is not the H alone, or not the whole H.
  if (!is_the_letter) {
    return WithLetterDirection(template_->WithinRing(seen, seen, BoxOf(detected.ring), *ring_poses));
  }
  return pad::FoundPad{.ring_outer = *ring_outer,
                       .ring_inner = pad::FitEllipse(contours.ring_inner),
                       .letter = *letter,
                       .stroke_angle = letter_.StrokeAngle(*normalized_letter),
                       .contours = std::move(contours),
                       .ring_box = pad::Scaled(BoxOf(detected.ring), seen.view.reduction),
                       .ring_poses = *ring_poses};
}

/// Whether the template matches on the plane of this pose where the letter's ellipse puts it.
bool PadSearch::IsTemplateUnder(const pad::Ellipse& normalized_letter, const pad::DownsampledImage& seen,
                                const pad::CirclePose& ring_pose) const {
  if (!letter_.HasDirection()) return false;
  const pad::PadPlane plane(ring_pose, seen.view);
  std::vector<Vector2d> on_plane;
  for (const Vector2d& point : pad::PointsOn(normalized_letter)) on_plane.push_back(plane.PointAlong(point));
  const auto letter = pad::FitEllipse(on_plane);
  if (!letter) return false;
  std::vector<pad::TemplateWarp> places(1);
  places[0].angle = letter_.StrokeAngle(*letter);
  if (!pad_.marks.empty()) places.emplace_back().angle = places[0].angle + models::kPi;
  return template_->print_match().IsAt(seen.image, plane, places);
}

std::optional<pad::FoundPad> PadSearch::ByEdges(const pad::DownsampledImage& usual) const {
  // Coarsely first, where blur and noise vanish and there is less to search.
  constexpr int kCoarse = 2;
  std::optional<pad::FoundPad> found;
  if (std::min(usual.image.width, usual.image.height) >= kCoarse) {
    const models::Image coarse = pad::Shrunk(usual.image, kCoarse);
    found = template_->ByEdges({coarse.View(), {camera_, undistort_, kCoarse * reduction_}}, usual);
  }
  if (!found) found = template_->ByEdges(usual, usual);
  return WithLetterDirection(std::move(found));
}

/// The direction of the strokes from the letter's ellipse, as Sec. IV-C.3 has it, where the ellipse has a direction.
std::optional<pad::FoundPad> PadSearch::WithLetterDirection(std::optional<pad::FoundPad> pad) const {
  if (!pad || !letter_.HasDirection()) return pad;
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(pad->letter, camera_));
  if (normalized_letter) pad->stroke_angle = letter_.StrokeAngle(*normalized_letter);
  return pad;
}

}  // namespace touchdown::estimator::paper
