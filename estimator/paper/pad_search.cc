#include "estimator/paper/pad_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "estimator/paper/letter_outline.h"
#include "models/angles.h"

namespace touchdown::estimator {
namespace {

using Eigen::Vector2d;

/// The steps are set for images about this wide; a larger one is reduced to it first.
constexpr int kUsualSide_px = 960;

/// Means over squares of `n` by `n` px; what is left at the right and the bottom is cut off.
models::Image Shrunk(const models::ImageView& image, int n) {
  const cv::Size size(image.width / n, image.height / n);
  const cv::Mat source(size.height * n, size.width * n, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                       static_cast<std::size_t>(image.stride));
  models::Image shrunk(size.width, size.height);
  cv::Mat target(size, CV_8UC1, shrunk.pixels.data());
  cv::resize(source, target, size, 0, 0, cv::INTER_AREA);
  return shrunk;
}

PixelBox Scaled(const PixelBox& box, int n) { return {n * box.u, n * box.v, n * box.width, n * box.height}; }

PixelBox BoxOf(const Component& c) { return {c.u, c.v, c.width, c.height}; }

PixelBox BoxOf(const Ellipse& ellipse) {
  const Vector2d half = ellipse.Shape().diagonal().cwiseSqrt();
  const Eigen::Vector2i low = (ellipse.center - half).array().floor().cast<int>();
  const Eigen::Vector2i high = (ellipse.center + half).array().ceil().cast<int>();
  return {low.x(), low.y(), high.x() - low.x() + 1, high.y() - low.y() + 1};
}

std::vector<Vector2d> PointsOn(const Ellipse& ellipse) {
  constexpr int kPoints = 60;
  const Eigen::Rotation2Dd from_axes(ellipse.angle);
  std::vector<Vector2d> points;
  for (int i = 0; i < kPoints; ++i) {
    const double t = 2.0 * models::kPi * i / kPoints;
    points.push_back(ellipse.center + from_axes * ellipse.semi_axes.cwiseProduct(Vector2d(std::cos(t), std::sin(t))));
  }
  return points;
}

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
                     FrameOrder frame_order, const PadSearchConfig& config)
    : camera_(camera),
      pad_(pad),
      config_(config),
      undistort_(camera),
      letter_(pad),
      detector_(pad, std::move(classify), config.pad_detector),
      print_(pad, config.print_match),
      searches_edges_(frame_order != FrameOrder::kFlight),
      reduction_(std::max(1, (std::max(camera.width_px, camera.height_px) + kUsualSide_px - 1) / kUsualSide_px)) {}

PadSearch::Result PadSearch::Find(const models::ImageView& image) const {
  const auto shrunk = reduction_ > 1 ? std::optional(Shrunk(image, reduction_)) : std::nullopt;
  const Reduced usual{shrunk ? shrunk->View() : image, {camera_, undistort_, reduction_}};
  Result result = ByComponents(usual);
  if (result.pad || !searches_edges_) return result;
  // Coarsely first, where blur and noise vanish and there is less to search.
  constexpr int kCoarse = 2;
  if (std::min(usual.image.width, usual.image.height) >= kCoarse) {
    const models::Image coarse = Shrunk(usual.image, kCoarse);
    result.pad = ByEdges({coarse.View(), {camera_, undistort_, kCoarse * reduction_}});
  }
  if (!result.pad) result.pad = ByEdges(usual);
  return result;
}

PadSearch::Result PadSearch::ByComponents(const Reduced& seen) const {
  const models::Image dark = Binarize(seen.image, config_.binarize);
  const ComponentSet components = ExtractComponents(dark.View(), config_.components);
  PadDetector::Result detection = detector_.Detect(components);
  Result result{.pad = std::nullopt, .failed = FrameStatus::kNoEllipse, .labelled = std::move(detection.labelled)};
  for (auto& each : result.labelled) {
    for (int* length : {&each.u, &each.v, &each.width, &each.height}) *length *= seen.view.reduction;
  }
  if (const auto* failed = std::get_if<FrameStatus>(&detection.outcome)) {
    result.failed = *failed;
    return result;
  }
  for (const DetectedPad& candidate : std::get<std::vector<DetectedPad>>(detection.outcome)) {
    if ((result.pad = Fit(seen, components, candidate))) break;
  }
  return result;
}

std::optional<FoundPad> PadSearch::Fit(const Reduced& seen, const ComponentSet& components,
                                       const DetectedPad& detected) const {
  PadContours contours = FindContours(seen.image, components, detected, pad_, config_.edges);
  Undistort(seen.view, contours);
  const auto ring_outer = FitRing(contours.ring_outer, config_.ring_fit);
  const auto letter = FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const auto ring_poses = PosesOfCircle(NormalizedConic(*ring_outer, camera_), pad_.outer_radius_m);
  const auto normalized_letter = Ellipse::FromConic(NormalizedConic(*letter, camera_));
  if (!ring_poses || !normalized_letter) return std::nullopt;
  for (const CirclePose& pose : *ring_poses) {
    const SeenPlane plane(pose, seen.view);
    std::vector<Vector2d> on_plane;
    for (const Vector2d& point : PointsOn(*normalized_letter)) on_plane.push_back(plane.PointAlong(point).head<2>());
    std::optional<PrintPlace> guess;
    const auto letter_on_plane = FitEllipse(on_plane);
    if (letter_on_plane && letter_.HasDirection()) guess = {.angle = letter_.StrokeAngle(*letter_on_plane)};
    const auto place = print_.Find(seen.image, plane, guess);
    if (!place) continue;
    // Where the letter's component does not lead to the print, it is not the H alone, or not the whole H.
    if (!guess || place->angle != guess->angle) return WithPrint(seen, BoxOf(detected.ring), plane, *place);
    return FoundPad{*ring_outer,
                    FitEllipse(contours.ring_inner),
                    *letter,
                    letter_.StrokeAngle(*normalized_letter),
                    std::move(contours),
                    Scaled(BoxOf(detected.ring), seen.view.reduction)};
  }
  return std::nullopt;
}

std::optional<FoundPad> PadSearch::ByEdges(const Reduced& seen) const {
  for (const Ellipse& ring : FindRings(seen.image, config_.ring_search)) {
    const auto poses = PosesOfCircle(NormalizedConic(Undistorted(ring, seen.view), camera_), pad_.outer_radius_m);
    if (!poses) continue;
    for (const CirclePose& pose : *poses) {
      const SeenPlane plane(pose, seen.view);
      const auto place = print_.Find(seen.image, plane);
      if (!place) continue;
      if (auto pad = WithPrint(seen, BoxOf(ring), plane, *place)) return pad;
    }
  }
  return std::nullopt;
}

std::optional<FoundPad> PadSearch::WithPrint(const Reduced& seen, const PixelBox& ring_box, const SeenPlane& plane,
                                             const PrintPlace& place) const {
  PadContours contours = FindContours(seen.image, ring_box, plane, place, pad_, config_.edges);
  Undistort(seen.view, contours);
  RingFitConfig broken = config_.ring_fit;
  broken.least_coverage = config_.ring_search.least_coverage;
  const auto ring_outer = FitRing(contours.ring_outer, broken);
  if (!ring_outer) return std::nullopt;
  constexpr double kSpacing = 0.1;  // Of a stroke.
  std::vector<Vector2d> outline;
  for (const Vector2d& p_W : LetterOutline(pad_, kSpacing * pad_.h_stroke_m)) {
    outline.push_back(camera_.PixelFromNormalized(plane.InCamera(place.OnPlane(p_W)).hnormalized()));
  }
  const auto letter = FitEllipse(outline);
  if (!letter) return std::nullopt;
  return FoundPad{
      *ring_outer,         FitEllipse(contours.ring_inner),      *letter, StrokeAngle(plane, place, *letter),
      std::move(contours), Scaled(ring_box, seen.view.reduction)};
}

void PadSearch::Undistort(const ReducedView& view, PadContours& contours) const {
  for (auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
    for (Vector2d& point : *contour) point = undistort_.At(view.CameraPixel(point));
  }
}

Ellipse PadSearch::Undistorted(const Ellipse& raw, const ReducedView& view) const {
  std::vector<Vector2d> points = PointsOn(raw);
  for (Vector2d& point : points) point = undistort_.At(view.CameraPixel(point));
  return FitEllipse(points).value_or(raw);
}

double PadSearch::StrokeAngle(const SeenPlane& plane, const PrintPlace& place, const Ellipse& letter) const {
  const auto normalized_letter = Ellipse::FromConic(NormalizedConic(letter, camera_));
  if (normalized_letter && letter_.HasDirection()) return letter_.StrokeAngle(*normalized_letter);
  const Vector2d from = plane.InCamera(place.OnPlane({-pad_.h_height_m / 2.0, 0.0})).hnormalized();
  const Vector2d to = plane.InCamera(place.OnPlane({pad_.h_height_m / 2.0, 0.0})).hnormalized();
  return models::WrapToHalfPi(std::atan2(to.y() - from.y(), to.x() - from.x()));
}

}  // namespace touchdown::estimator
