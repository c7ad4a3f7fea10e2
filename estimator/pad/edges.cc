#include "estimator/pad/edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "models/bilinear.h"
#include "models/error.h"
#include "models/pad_outline.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

constexpr int kPatchMargin_px = 8;

// Largest half width of the window across an edge. It contains the whole transition of an edge that is blurred by 2 px.
constexpr double kMaxHalfWindow_px = 3.0;
// Smallest half width. A shorter window measures the interpolation between two pixels instead of the edge, and its
// scatter is three times as large. For stripes narrower than two pixels the window therefore extends beyond their
// middle.
constexpr double kMinHalfWindow_px = 1.0;
constexpr double kProfileStep_px = 0.5;
constexpr double kMaxShift_px = 1.5;
constexpr double kMinContrast = 20.0;
// Canny's thresholds and kMinContrast apply to patches of at least this contrast. For patches of less contrast, in dim
// light, they are reduced in proportion.
constexpr double kFullContrast = 100.0;

constexpr double kAligned = 0.7;  // Smallest cosine between an edge's gradient and the ring's normal.

/// The part of the image around the pad, with its gradients and edges.
struct Patch {
  int u, v, width, height;
  cv::Mat gray;                    // The image's own pixels.
  cv::Mat gradient_u, gradient_v;  // Sobel, 16 bit.
  cv::Mat edges;
  double contrast_scale;  // Factor of the thresholds: 1, or less for a patch of low contrast.

  Vector2d GradientAt(int x, int y) const { return {gradient_u.at<short>(y, x), gradient_v.at<short>(y, x)}; }

  models::ImageView view() const { return {gray.data, width, height, static_cast<std::ptrdiff_t>(gray.step)}; }
  double GrayAt(const Vector2d& p) const { return models::BilinearGray<double>(view(), p); }
  bool Contains(const Vector2d& p) const { return models::IsBetweenPixels(view(), p); }
};

/// Contrast of an image, as the difference of two gray values that fill half of it each.
double Contrast(const cv::Mat& gray) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(gray, mean, deviation);
  return 2.0 * deviation[0];
}

Patch MakePatch(const models::ImageView& image, const PixelBox& ring_box, const EdgeConfig& config) {
  Patch patch;
  patch.u = std::max(0, ring_box.u - kPatchMargin_px);
  patch.v = std::max(0, ring_box.v - kPatchMargin_px);
  patch.width = std::min(image.width, ring_box.u + ring_box.width + kPatchMargin_px) - patch.u;
  patch.height = std::min(image.height, ring_box.v + ring_box.height + kPatchMargin_px) - patch.v;
  patch.gray = cv::Mat(patch.height, patch.width, CV_8UC1, const_cast<std::uint8_t*>(image.Row(patch.v) + patch.u),
                       static_cast<std::size_t>(image.stride));
  cv::Sobel(patch.gray, patch.gradient_u, CV_16S, 1, 0);
  cv::Sobel(patch.gray, patch.gradient_v, CV_16S, 0, 1);
  patch.contrast_scale = std::min(1.0, Contrast(patch.gray) / kFullContrast);
  cv::Canny(patch.gradient_u, patch.gradient_v, patch.edges, patch.contrast_scale * config.canny_low,
            patch.contrast_scale * config.canny_high, true);
  return patch;
}

/// Sub-pixel position of an edge along its gradient, in px of the patch.
///
/// It is the position at which the mean of a centered window is midway between the gray values at the window's ends, so
/// that the window has as much dark as bright. A symmetric blur does not shift it, even if the window truncates the
/// blur's tails. The window extends to both sides by `max_half_window`, px, rounded down to a whole number of steps.
/// nullopt when the window leaves the patch, the contrast is too low, or the position is too far from the pixel.
std::optional<Vector2d> SubpixelPosition(const Patch& patch, const Vector2d& pixel, const Vector2d& to_bright,
                                         double max_half_window) {
  const int half_count = static_cast<int>(max_half_window / kProfileStep_px);
  const double half_window = half_count * kProfileStep_px;
  double shift = 0.0;
  constexpr int kIterations = 2;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Vector2d middle = pixel + shift * to_bright;
    const Vector2d dark_end = middle - half_window * to_bright, bright_end = middle + half_window * to_bright;
    if (!patch.Contains(dark_end) || !patch.Contains(bright_end)) return std::nullopt;
    const double dark = patch.GrayAt(dark_end), bright = patch.GrayAt(bright_end);
    const double contrast = bright - dark;
    if (contrast < patch.contrast_scale * kMinContrast) return std::nullopt;
    double above_dark = 0.5 * contrast;
    for (int i = 1 - half_count; i < half_count; ++i) {
      above_dark += patch.GrayAt(middle + i * kProfileStep_px * to_bright) - dark;
    }
    shift += std::clamp(half_window - kProfileStep_px * above_dark / contrast, -1.0, 1.0);
  }
  if (std::abs(shift) > kMaxShift_px) return std::nullopt;
  return pixel + shift * to_bright;
}

/// Half width of the window across an edge, px, such that it contains no other edge of the pad.
double HalfWindow(const PixelBox& ring_box, const models::LandingPad& pad) {
  const double px_per_m = std::min(ring_box.width, ring_box.height) / (2.0 * pad.outer_radius_m);
  return std::clamp(0.5 * models::PadOutline(pad).narrowest_m() * px_per_m, kMinHalfWindow_px, kMaxHalfWindow_px);
}

/// The edge points of the patch by contour, raw px.
PadContours ContoursOf(const Patch& patch, double half_window, const EdgeConfig& config,
                       const ContourClassifier& classify) {
  PadContours contours;
  const Vector2d origin(patch.u, patch.v);
  for (int y = 1; y < patch.height - 1; ++y) {
    const std::uint8_t* edge_row = patch.edges.ptr(y);
    for (int x = 1; x < patch.width - 1; ++x) {
      if (edge_row[x] == 0) continue;
      const Vector2d pixel(x, y), to_bright = patch.GradientAt(x, y).normalized();
      const Contour contour = classify(origin + pixel, to_bright);
      if (contour == Contour::kNone) continue;
      const auto point = config.contour_points == ContourPoints::kInteger
                             ? pixel
                             : SubpixelPosition(patch, pixel, to_bright, half_window);
      if (!point) continue;
      auto& points = contour == Contour::kLetter      ? contours.letter
                     : contour == Contour::kRingOuter ? contours.ring_outer
                                                      : contours.ring_inner;
      points.push_back(*point + origin);
    }
  }
  return contours;
}

}  // namespace

void EdgeConfig::Validate() const {
  if (!std::isfinite(canny_low) || !std::isfinite(canny_high) || canny_low <= 0.0 || canny_high < canny_low) {
    throw InputError("canny_low and canny_high must be positive and finite, and canny_low at most canny_high");
  }
}

PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const ContourClassifier& classify,
                         const models::LandingPad& pad, const EdgeConfig& config) {
  return ContoursOf(MakePatch(image, ring_box, config), HalfWindow(ring_box, pad), config, classify);
}

PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const PadPlane& plane,
                         const TemplateWarp& warp, const models::LandingPad& pad, const EdgeConfig& config) {
  constexpr double kNear = 0.4;   // Fraction of the narrower of letter stroke and ring.
  constexpr double kCurl = 0.06;  // Fraction of the outer radius, for paper that is not flat.
  const double near_m = kNear * std::min(pad.h_stroke_m, pad.ring_width_m);
  const double near_ring_m = std::max(near_m, kCurl * pad.outer_radius_m);
  const models::PadOutline outline(pad);
  const ContourClassifier nearest = [&](const Vector2d& pixel, const Vector2d& to_bright) {
    const Vector2d p = plane.PointAt(pixel);
    const Vector2d outwards = (plane.PointAt(pixel + to_bright) - p).normalized();
    const double radius = p.norm(), cos_outwards = outwards.dot(p) / radius;
    if (cos_outwards > kAligned && std::abs(radius - pad.outer_radius_m) < near_ring_m) return Contour::kRingOuter;
    if (cos_outwards < -kAligned && std::abs(radius - pad.inner_radius_m()) < near_m) return Contour::kRingInner;
    return outline.DistanceFromLetter(warp.OnTemplate(p)) < near_m ? Contour::kLetter : Contour::kNone;
  };
  return FindContours(image, ring_box, nearest, pad, config);
}

}  // namespace touchdown::estimator::pad
