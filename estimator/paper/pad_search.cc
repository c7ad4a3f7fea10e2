#include "estimator/paper/pad_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "models/angles.h"
#include "models/pad_outline.h"

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;

/// The steps are set for images no wider than this; a larger one is reduced first, by a whole number.
constexpr int kUsualSide_px = 960;

int ReductionOf(const models::CameraModel& camera) {
  const auto [shorter, longer] = std::minmax(camera.width_px, camera.height_px);
  return std::clamp((longer + kUsualSide_px - 1) / kUsualSide_px, 1, shorter);
}

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

PixelBox BoxOf(const pad::Ellipse& ellipse) {
  const Vector2d half = ellipse.Shape().diagonal().cwiseSqrt();
  const Eigen::Vector2i low = (ellipse.center - half).array().floor().cast<int>();
  const Eigen::Vector2i high = (ellipse.center + half).array().ceil().cast<int>();
  return {low.x(), low.y(), high.x() - low.x() + 1, high.y() - low.y() + 1};
}

std::vector<Vector2d> PointsOn(const pad::Ellipse& ellipse) {
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
                     FrameOrder frame_order, const PadSearchConfig& config, std::function<void(FrameStage)> on_stage)
    : camera_(camera),
      pad_(pad),
      config_(config),
      undistort_(camera),
      letter_(pad),
      detector_(pad, std::move(classify), config.pad_detector),
      print_(pad, config.print_match),
      searches_edges_(frame_order != FrameOrder::kFlight),
      on_stage_(std::move(on_stage)),
      reduction_(ReductionOf(camera)) {}

PadSearch::Result PadSearch::Find(const models::ImageView& image) const {
  Enter(FrameStage::kRecognition);
  const auto shrunk = reduction_ > 1 ? std::optional(Shrunk(image, reduction_)) : std::nullopt;
  const Reduced usual{shrunk ? shrunk->View() : image, {camera_, undistort_, reduction_}};
  Result result = ByComponents(usual);
  if (result.pad || !searches_edges_) return result;
  Enter(FrameStage::kRecognition);
  // Coarsely first, where blur and noise vanish and there is less to search.
  constexpr int kCoarse = 2;
  if (std::min(usual.image.width, usual.image.height) >= kCoarse) {
    const models::Image coarse = Shrunk(usual.image, kCoarse);
    result.pad = ByEdges({coarse.View(), {camera_, undistort_, kCoarse * reduction_}}, usual);
  }
  if (!result.pad) result.pad = ByEdges(usual, usual);
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
  Enter(FrameStage::kGeometry);
  for (const DetectedPad& candidate : std::get<std::vector<DetectedPad>>(detection.outcome)) {
    if ((result.pad = Fit(seen, components, candidate))) break;
  }
  return result;
}

std::optional<FoundPad> PadSearch::Fit(const Reduced& seen, const ComponentSet& components,
                                       const DetectedPad& detected) const {
  pad::PadContours contours = FindContours(seen.image, components, detected, pad_, config_.edges);
  Undistort(seen.view, contours);
  const auto ring_outer = pad::FitRing(contours.ring_outer, config_.ring_fit);
  const auto letter = pad::FitEllipse(contours.letter);
  if (!ring_outer || !letter) return std::nullopt;
  const auto ring_poses = pad::PosesOfCircle(pad::NormalizedConic(*ring_outer, camera_), pad_.outer_radius_m);
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(*letter, camera_));
  if (!ring_poses || !normalized_letter) return std::nullopt;
  const bool is_the_letter = std::any_of(ring_poses->begin(), ring_poses->end(), [&](const pad::CirclePose& pose) {
    return IsPrintUnder(*normalized_letter, seen, pose);
  });
  // Else its component is not the H alone, or not the whole H.
  if (!is_the_letter) return ByPrint(seen, seen, BoxOf(detected.ring), *ring_poses);
  return FoundPad{*ring_outer,
                  pad::FitEllipse(contours.ring_inner),
                  *letter,
                  letter_.StrokeAngle(*normalized_letter),
                  std::move(contours),
                  Scaled(BoxOf(detected.ring), seen.view.reduction)};
}

/// Whether the letter's ellipse tells where the print is, on the plane of this pose.
bool PadSearch::IsPrintUnder(const pad::Ellipse& normalized_letter, const Reduced& seen,
                             const pad::CirclePose& ring_pose) const {
  if (!letter_.HasDirection()) return false;
  const pad::SeenPlane plane(ring_pose, seen.view);
  std::vector<Vector2d> on_plane;
  for (const Vector2d& point : PointsOn(normalized_letter)) on_plane.push_back(plane.PointAlong(point));
  const auto letter = pad::FitEllipse(on_plane);
  if (!letter) return false;
  const double angle = letter_.StrokeAngle(*letter);
  std::vector<pad::PrintPlace> places{{.angle = angle}};
  if (!pad_.marks.empty()) places.push_back({.angle = angle + models::kPi});  // The H alone looks the same.
  return print_.IsAt(seen.image, plane, places);
}

std::optional<FoundPad> PadSearch::ByEdges(const Reduced& searched, const Reduced& measured) const {
  for (const pad::Ellipse& ring : pad::FindRings(searched.image, config_.ring_search)) {
    const auto poses =
        pad::PosesOfCircle(pad::NormalizedConic(Undistorted(ring, searched.view), camera_), pad_.outer_radius_m);
    if (!poses) continue;
    const PixelBox box = Scaled(BoxOf(ring), searched.view.reduction / measured.view.reduction);
    if (auto pad = ByPrint(searched, measured, box, *poses)) return pad;
  }
  return std::nullopt;
}

std::optional<FoundPad> PadSearch::ByPrint(const Reduced& searched, const Reduced& measured, const PixelBox& ring_box,
                                           const std::array<pad::CirclePose, 2>& ring_poses) const {
  std::vector<std::pair<pad::PrintMatch::Found, pad::CirclePose>> prints;
  for (const pad::CirclePose& pose : ring_poses) {
    if (const auto found = print_.Find(searched.image, pad::SeenPlane(pose, searched.view)))
      prints.emplace_back(*found, pose);
  }
  std::stable_sort(prints.begin(), prints.end(),
                   [](const auto& a, const auto& b) { return a.first.likeness > b.first.likeness; });
  for (const auto& [found, pose] : prints) {
    if (auto pad = Measure(measured, ring_box, pad::SeenPlane(pose, measured.view), found.place)) return pad;
  }
  return std::nullopt;
}

std::optional<FoundPad> PadSearch::Measure(const Reduced& seen, const PixelBox& ring_box, const pad::SeenPlane& plane,
                                           const pad::PrintPlace& place) const {
  pad::PadContours contours = pad::FindContours(seen.image, ring_box, plane, place, pad_, config_.edges);
  Undistort(seen.view, contours);
  pad::RingFitConfig broken = config_.ring_fit;
  broken.least_coverage = config_.ring_search.least_coverage;
  const auto ring_outer = pad::FitRing(contours.ring_outer, broken);
  if (!ring_outer) return std::nullopt;
  constexpr double kSpacing = 0.1;  // Of a stroke.
  std::vector<Vector2d> outline;
  for (const Vector2d& p_W : models::PadOutline(pad_).PointsAlongLetter(kSpacing * pad_.h_stroke_m)) {
    outline.push_back(camera_.PixelFromNormalized(plane.InCamera(place.OnPlane(p_W)).hnormalized()));
  }
  const auto letter = pad::FitEllipse(outline);
  if (!letter) return std::nullopt;
  return FoundPad{
      *ring_outer,         pad::FitEllipse(contours.ring_inner), *letter, StrokeAngle(plane, place, *letter),
      std::move(contours), Scaled(ring_box, seen.view.reduction)};
}

void PadSearch::Undistort(const pad::ReducedView& view, pad::PadContours& contours) const {
  for (auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
    for (Vector2d& point : *contour) point = undistort_.At(view.CameraPixel(point));
  }
}

pad::Ellipse PadSearch::Undistorted(const pad::Ellipse& raw, const pad::ReducedView& view) const {
  std::vector<Vector2d> points = PointsOn(raw);
  for (Vector2d& point : points) point = undistort_.At(view.CameraPixel(point));
  return pad::FitEllipse(points).value_or(raw);
}

double PadSearch::StrokeAngle(const pad::SeenPlane& plane, const pad::PrintPlace& place,
                              const pad::Ellipse& letter) const {
  const auto normalized_letter = pad::Ellipse::FromConic(pad::NormalizedConic(letter, camera_));
  if (normalized_letter && letter_.HasDirection()) return letter_.StrokeAngle(*normalized_letter);
  const Vector2d from = plane.InCamera(place.OnPlane({-pad_.h_height_m / 2.0, 0.0})).hnormalized();
  const Vector2d to = plane.InCamera(place.OnPlane({pad_.h_height_m / 2.0, 0.0})).hnormalized();
  return models::WrapToHalfPi(std::atan2(to.y() - from.y(), to.x() - from.x()));
}

}  // namespace touchdown::estimator::paper
