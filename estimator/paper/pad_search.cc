#include "estimator/paper/pad_search.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace touchdown::estimator {
namespace {

using Eigen::Vector2d;

/// The looks are set for images about this wide; a larger one is reduced to it first.
constexpr int kUsualSide_px = 960;

/// Means over squares of `n` by `n` px; what is left at the right and the bottom is cut off.
models::Image Reduced(const models::ImageView& image, int n) {
  const cv::Size size(image.width / n, image.height / n);
  const cv::Mat source(size.height * n, size.width * n, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                       static_cast<std::size_t>(image.stride));
  models::Image reduced(size.width, size.height);
  cv::Mat target(size, CV_8UC1, reduced.pixels.data());
  cv::resize(source, target, size, 0, 0, cv::INTER_AREA);
  return reduced;
}

Vector2d Enlarged(const Vector2d& pixel, int n) {
  return n * (pixel + Vector2d::Constant(0.5)) - Vector2d::Constant(0.5);
}

PixelBox BoxOf(const Component& c, int n) { return {n * c.u, n * c.v, n * c.width, n * c.height}; }

void Enlarge(int n, std::vector<FrameTrace::Component>& labelled) {
  for (auto& each : labelled) {
    for (int* length : {&each.u, &each.v, &each.width, &each.height}) *length *= n;
  }
}

}  // namespace

void PadSearchConfig::Validate() const {
  binarize.Validate();
  components.Validate();
  pad_detector.Validate();
  edges.Validate();
  letter_check.Validate();
  ring_fit.Validate();
}

PadSearch::PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
                     const PadSearchConfig& config)
    : camera_(camera),
      pad_(pad),
      config_(config),
      undistort_(camera),
      letter_(pad),
      letter_check_(pad, config.letter_check) {
  const int usual = std::max(1, (std::max(camera.width_px, camera.height_px) + kUsualSide_px - 1) / kUsualSide_px);
  const auto look = [&](int reduction, const BinarizeConfig& binarize, double least_posterior) {
    if (std::min(camera.width_px, camera.height_px) < reduction) return;
    PadDetectorConfig detector = config.pad_detector;
    detector.least_posterior = least_posterior;
    looks_.push_back({reduction, binarize, PadDetector(pad, classify, detector)});
  };
  constexpr double kLeastPosterior = 0.1;
  BinarizeConfig narrow = config.binarize;
  narrow.window_px = 41;
  BinarizeConfig sensitive = config.binarize;
  sensitive.relative_margin = 0.06;
  sensitive.absolute_margin = 3.0;
  look(usual, config.binarize, config.pad_detector.least_posterior);
  look(2 * usual, config.binarize, kLeastPosterior);
  look(usual, narrow, kLeastPosterior);
  if (usual > 1) look(usual / 2, config.binarize, kLeastPosterior);
  look(usual, config.binarize, kLeastPosterior);
  look(usual, sensitive, kLeastPosterior);
}

PadSearch::Result PadSearch::Find(const models::ImageView& image) const {
  Result first = FindBy(looks_.front(), image);
  for (auto look = looks_.begin() + 1; look != looks_.end() && !first.pad; ++look) {
    Result next = FindBy(*look, image);
    if (next.pad) return next;
  }
  return first;
}

PadSearch::Result PadSearch::FindBy(const Look& look, const models::ImageView& image) const {
  models::Image reduced;
  models::ImageView view = image;
  if (look.reduction > 1) {
    reduced = Reduced(image, look.reduction);
    view = reduced.View();
  }
  const models::Image dark = Binarize(view, look.binarize);
  const ComponentSet components = ExtractComponents(dark.View(), config_.components);
  PadDetector::Result detection = look.detector.Detect(components);
  Result result{.pad = std::nullopt, .failed = FrameStatus::kNoEllipse, .labelled = std::move(detection.labelled)};
  Enlarge(look.reduction, result.labelled);
  if (const auto* failed = std::get_if<FrameStatus>(&detection.outcome)) {
    result.failed = *failed;
    return result;
  }
  for (const DetectedPad& candidate : std::get<std::vector<DetectedPad>>(detection.outcome)) {
    if ((result.pad = Fit(look, view, components, candidate))) break;
  }
  return result;
}

std::optional<FoundPad> PadSearch::Fit(const Look& look, const models::ImageView& reduced,
                                       const ComponentSet& components, const DetectedPad& detected) const {
  PadContours contours = FindContours(reduced, components, detected, pad_, config_.edges);
  for (auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
    for (Vector2d& point : *contour) point = undistort_.At(Enlarged(point, look.reduction));
  }
  const auto ring_outer = FitRing(contours.ring_outer, config_.ring_fit);
  const auto letter = FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const ComponentView view{camera_, undistort_, look.reduction};
  const auto ring_poses = PosesOfCircle(NormalizedConic(*ring_outer, camera_), pad_.outer_radius_m);
  if (!ring_poses || !letter_check_.Passes(*ring_poses, components, detected.letter, view)) {
    return std::nullopt;
  }
  const auto normalized_letter = Ellipse::FromConic(NormalizedConic(*letter, camera_));
  if (!normalized_letter) return std::nullopt;
  return FoundPad{
      *ring_outer,         FitEllipse(contours.ring_inner),     *letter, letter_.StrokeAngle(*normalized_letter),
      std::move(contours), BoxOf(detected.ring, look.reduction)};
}

}  // namespace touchdown::estimator
