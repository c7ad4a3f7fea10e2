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

// Half the window across an edge is at most this, which holds the whole transition of an edge that is blurred by 2 px,
constexpr double kLongestReach_px = 3.0;
// and at least this: a shorter one sees the interpolation between two pixels, not the edge, and scatters threefold. So
// where stripes are narrower than two pixels, the window goes beyond their middles.
constexpr double kShortestReach_px = 1.0;
constexpr double kProfileStep_px = 0.5;
constexpr double kFarthestMove_px = 1.5;
constexpr double kLeastContrast = 20.0;
// Canny's thresholds and the least contrast are for pads of this contrast at least; for a fainter one, in little light,
// they are as much lower.
constexpr double kUsualContrast = 100.0;

constexpr double kAligned = 0.7;  // Cosine between an edge's gradient and the ring's normal.

/// The gray values around the pad, with their edges.
struct Patch {
  int u, v, width, height;
  cv::Mat gray;                    // The image's own pixels.
  cv::Mat gradient_u, gradient_v;  // Sobel, 16 bit.
  cv::Mat edges;
  double faintness;  // 1, or less where the patch has little contrast.

  Vector2d GradientAt(int x, int y) const { return {gradient_u.at<short>(y, x), gradient_v.at<short>(y, x)}; }

  models::ImageView view() const { return {gray.data, width, height, static_cast<std::ptrdiff_t>(gray.step)}; }
  double GrayAt(const Vector2d& p) const { return models::BilinearGray<double>(view(), p); }
  bool Holds(const Vector2d& p) const { return models::IsBetweenPixels(view(), p); }
};

/// Of a picture of two gray values, about as much of each.
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
  patch.faintness = std::min(1.0, Contrast(patch.gray) / kUsualContrast);
  cv::Canny(patch.gradient_u, patch.gradient_v, patch.edges, patch.faintness * config.canny_low,
            patch.faintness * config.canny_high, true);
  return patch;
}

/// The place along the gradient about which the window's mean is midway between its ends: where a window centered on it
/// sees as much dark as bright. A blur that is the same on both sides does not move it, even when the window cuts its
/// tails off. The window reaches `reach`, px, to both sides, less what is not a whole step. nullopt where it leaves the
/// patch, the contrast is too weak or the place too far from the pixel.
std::optional<Vector2d> SubpixelPlace(const Patch& patch, const Vector2d& pixel, const Vector2d& to_bright,
                                      double reach) {
  const int half_count = static_cast<int>(reach / kProfileStep_px);
  const double half_window = half_count * kProfileStep_px;
  double move = 0.0;
  constexpr int kIterations = 2;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Vector2d middle = pixel + move * to_bright;
    const Vector2d dark_end = middle - half_window * to_bright, bright_end = middle + half_window * to_bright;
    if (!patch.Holds(dark_end) || !patch.Holds(bright_end)) return std::nullopt;
    const double dark = patch.GrayAt(dark_end), bright = patch.GrayAt(bright_end);
    const double contrast = bright - dark;
    if (contrast < patch.faintness * kLeastContrast) return std::nullopt;
    double above_dark = 0.5 * contrast;
    for (int i = 1 - half_count; i < half_count; ++i) {
      above_dark += patch.GrayAt(middle + i * kProfileStep_px * to_bright) - dark;
    }
    move += std::clamp(half_window - kProfileStep_px * above_dark / contrast, -1.0, 1.0);
  }
  if (std::abs(move) > kFarthestMove_px) return std::nullopt;
  return pixel + move * to_bright;
}

/// Half the window across an edge: so far from it no other edge of the pad is met.
double Reach(const PixelBox& ring_box, const models::LandingPad& pad) {
  const double px_per_m = std::min(ring_box.width, ring_box.height) / (2.0 * pad.outer_radius_m);
  return std::clamp(0.5 * models::PadOutline(pad).narrowest_m() * px_per_m, kShortestReach_px, kLongestReach_px);
}

/// The patch's edge points by contour, raw px.
PadContours Sorted(const Patch& patch, double reach, const EdgeConfig& config, const ContourOf& contour_of) {
  PadContours contours;
  const Vector2d origin(patch.u, patch.v);
  for (int y = 1; y < patch.height - 1; ++y) {
    const std::uint8_t* edge_row = patch.edges.ptr(y);
    for (int x = 1; x < patch.width - 1; ++x) {
      if (edge_row[x] == 0) continue;
      const Vector2d pixel(x, y), to_bright = patch.GradientAt(x, y).normalized();
      const Contour contour = contour_of(origin + pixel, to_bright);
      if (contour == Contour::kNone) continue;
      const auto point =
          config.contour_points == ContourPoints::kInteger ? pixel : SubpixelPlace(patch, pixel, to_bright, reach);
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
    throw InputError("Canny's thresholds must be positive, finite and in order");
  }
}

PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const ContourOf& contour_of,
                         const models::LandingPad& pad, const EdgeConfig& config) {
  return Sorted(MakePatch(image, ring_box, config), Reach(ring_box, pad), config, contour_of);
}

PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const PadPlane& plane,
                         const TemplateWarp& place, const models::LandingPad& pad, const EdgeConfig& config) {
  constexpr double kNear = 0.4, kCurl = 0.06;  // Of the narrower stroke; of the radius.
  const double near_m = kNear * std::min(pad.h_stroke_m, pad.ring_width_m);
  const double near_ring_m = std::max(near_m, kCurl * pad.outer_radius_m);
  const models::PadOutline outline(pad);
  const ContourOf nearest = [&](const Vector2d& pixel, const Vector2d& to_bright) {
    const Vector2d p = plane.PointAt(pixel);
    const Vector2d outwards = (plane.PointAt(pixel + to_bright) - p).normalized();
    const double radius = p.norm(), cos_outwards = outwards.dot(p) / radius;
    if (cos_outwards > kAligned && std::abs(radius - pad.outer_radius_m) < near_ring_m) return Contour::kRingOuter;
    if (cos_outwards < -kAligned && std::abs(radius - pad.inner_radius_m()) < near_m) return Contour::kRingInner;
    return outline.DistanceFromLetter(place.OnTemplate(p)) < near_m ? Contour::kLetter : Contour::kNone;
  };
  return FindContours(image, ring_box, nearest, pad, config);
}

}  // namespace touchdown::estimator::pad
