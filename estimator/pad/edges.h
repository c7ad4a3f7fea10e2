#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "estimator/overlay.h"
#include "estimator/pad/pad_plane.h"
#include "estimator/pad/pad_template_matcher.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// Position of the edge points: the pixels of Canny's edges, or sub-pixel positions along the gradient. The paper does
/// not specify it.
enum class ContourPoints { kInteger, kSubpixel };

/// Settings of the edge detection.
struct EdgeConfig {
  ContourPoints contour_points = ContourPoints::kSubpixel;
  /// Canny's thresholds on the 3x3 Sobel gradient, which is four times the gray value difference over two pixels. Lower
  /// thresholds detect blurred or faint edges; higher ones reject noise: for noise of sigma 3 of 255 the gradient
  /// is about 15. For a pad of low contrast both thresholds are reduced.
  double canny_low = 60.0;
  double canny_high = 120.0;

  /// Throws InputError unless both thresholds are finite and positive and canny_low <= canny_high.
  void Validate() const;
};

/// Edge points of the pad's three contours, raw px.
struct PadContours {
  std::vector<Eigen::Vector2d> ring_outer, ring_inner, letter;
};

/// Contour to which an edge point belongs.
enum class Contour : std::uint8_t { kNone, kRingOuter, kRingInner, kLetter };

/// Returns the contour of an edge pixel (raw px); `to_bright` is the unit vector towards its bright side.
using ContourClassifier = std::function<Contour(const Eigen::Vector2d& pixel, const Eigen::Vector2d& to_bright)>;

/// Canny's edges in the patch around `ring_box`, which encloses the ring, assigned to contours by `classify` (Sec.
/// IV-B). With ContourPoints::kSubpixel each point is shifted along the gradient to its sub-pixel position. Pixels at
/// the image border are ignored.
PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const ContourClassifier& classify,
                         const models::LandingPad& pad, const EdgeConfig& config = {});

/// Same as above, but assigns each edge pixel to the nearest contour of the template, which lies at `warp` on the
/// ring's plane.
PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const PadPlane& plane,
                         const TemplateWarp& warp, const models::LandingPad& pad, const EdgeConfig& config = {});

}  // namespace touchdown::estimator::pad
