#include "estimator/pad/template_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "models/angles.h"
#include "models/pad_outline.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

/// Bounding box of an ellipse.
PixelBox BoxOf(const Ellipse& ellipse) {
  const Vector2d half = ellipse.Shape().diagonal().cwiseSqrt();
  const Eigen::Vector2i low = (ellipse.center - half).array().floor().cast<int>();
  const Eigen::Vector2i high = (ellipse.center + half).array().ceil().cast<int>();
  return {low.x(), low.y(), high.x() - low.x() + 1, high.y() - low.y() + 1};
}

/// The ellipse in undistorted camera pixels.
Ellipse Undistorted(const Ellipse& raw, const DownsampledCamera& view) {
  std::vector<Vector2d> points = PointsOn(raw);
  for (Vector2d& point : points) point = view.undistort.At(view.CameraPixel(point));
  return FitEllipse(points).value_or(raw);
}

}  // namespace

models::Image Downsampled(const models::ImageView& image, int n) {
  const cv::Size size(image.width / n, image.height / n);
  const cv::Mat source(size.height * n, size.width * n, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                       static_cast<std::size_t>(image.stride));
  models::Image downsampled(size.width, size.height);
  cv::Mat target(size, CV_8UC1, downsampled.pixels.data());
  cv::resize(source, target, size, 0, 0, cv::INTER_AREA);
  return downsampled;
}

PixelBox Scaled(const PixelBox& box, int n) { return {n * box.u, n * box.v, n * box.width, n * box.height}; }

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

void Undistort(const DownsampledCamera& view, PadContours& contours) {
  for (auto* contour : {&contours.ring_outer, &contours.ring_inner, &contours.letter}) {
    for (Vector2d& point : *contour) point = view.undistort.At(view.CameraPixel(point));
  }
}

void TemplateSearchConfig::Validate() const {
  edges.Validate();
  ring_fit.Validate();
  template_matcher.Validate();
  ellipse_detection.Validate();
}

TemplateSearch::TemplateSearch(const models::CameraModel& camera, const models::LandingPad& pad,
                               const TemplateSearchConfig& config)
    : camera_(camera), pad_(pad), config_(config), matcher_(pad, config.template_matcher) {}

std::optional<FoundPad> TemplateSearch::FindByEdges(const DownsampledImage& searched,
                                                    const DownsampledImage& measured) const {
  for (const Ellipse& ring : DetectEllipses(searched.image, config_.ellipse_detection)) {
    const auto poses = PosesOf(Undistorted(ring, searched.view));
    if (!poses) continue;
    const PixelBox box = Scaled(BoxOf(ring), searched.view.reduction / measured.view.reduction);
    if (auto pad = FindWithinRing(searched, measured, box, *poses)) return pad;
  }
  return std::nullopt;
}

std::optional<FoundPad> TemplateSearch::FindWithinRing(const DownsampledImage& searched,
                                                       const DownsampledImage& measured, const PixelBox& ring_box,
                                                       const std::array<CirclePose, 2>& ring_poses) const {
  std::vector<std::pair<PadTemplateMatcher::Match, CirclePose>> matches;
  for (const CirclePose& pose : ring_poses) {
    if (const auto match = matcher_.Find(searched.image, PadPlane(pose, searched.view)))
      matches.emplace_back(*match, pose);
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const auto& a, const auto& b) { return a.first.zncc > b.first.zncc; });
  for (const auto& [match, pose] : matches) {
    if (auto pad = Measure(measured, ring_box, PadPlane(pose, measured.view), match.warp)) return pad;
  }
  return std::nullopt;
}

std::optional<FoundPad> TemplateSearch::Measure(const DownsampledImage& input, const PixelBox& ring_box,
                                                const PadPlane& plane, const TemplateWarp& warp) const {
  PadContours contours = FindContours(input.image, ring_box, plane, warp, pad_, config_.edges);
  Undistort(input.view, contours);
  RingFitConfig interrupted_ring = config_.ring_fit;
  interrupted_ring.min_coverage = config_.ellipse_detection.min_coverage;
  const auto ring_outer = FitRing(contours.ring_outer, interrupted_ring);
  if (!ring_outer) return std::nullopt;
  const auto ring_poses = PosesOf(*ring_outer);
  if (!ring_poses) return std::nullopt;
  constexpr double kSpacing = 0.1;  // Fraction of a stroke.
  std::vector<Vector2d> outline;
  for (const Vector2d& p_W : models::PadOutline(pad_).PointsAlongLetter(kSpacing * pad_.h_stroke_m)) {
    outline.push_back(camera_.PixelFromNormalized(plane.InCamera(warp.OnPlane(p_W)).hnormalized()));
  }
  const auto letter = FitEllipse(outline);
  if (!letter) return std::nullopt;
  const auto ring_inner = FitEllipse(contours.ring_inner);
  return FoundPad{.ring_outer = *ring_outer,
                  .ring_inner = ring_inner,
                  .letter = *letter,
                  .stroke_angle = StrokeAngle(plane, warp),
                  .contours = std::move(contours),
                  .ring_box = Scaled(ring_box, input.view.reduction),
                  .ring_poses = *ring_poses};
}

std::optional<std::array<CirclePose, 2>> TemplateSearch::PosesOf(const Ellipse& ring) const {
  return PosesOfCircle(NormalizedConic(ring, camera_), pad_.outer_radius_m);
}

double TemplateSearch::StrokeAngle(const PadPlane& plane, const TemplateWarp& warp) const {
  const Vector2d from = plane.InCamera(warp.OnPlane({-pad_.h_height_m / 2.0, 0.0})).hnormalized();
  const Vector2d to = plane.InCamera(warp.OnPlane({pad_.h_height_m / 2.0, 0.0})).hnormalized();
  return models::WrapToHalfPi(std::atan2(to.y() - from.y(), to.x() - from.x()));
}

}  // namespace touchdown::estimator::pad
