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

/// Where a frame's edge points are taken: on Canny's pixels, or at their sub-pixel place along the gradient. The paper
/// leaves it open.
enum class ContourPoints { kInteger, kSubpixel };

struct EdgeConfig {
  ContourPoints contour_points = ContourPoints::kSubpixel;
  /// Canny's thresholds on Sobel's gradient (3x3; four times the gray values' difference over two pixels). Lower ones
  /// follow blurred or faint edges, higher ones keep noise out: sigma 3 of 255 gives some 15. They are lowered
  /// for a pad of faint contrast.
  double canny_low = 60.0;
  double canny_high = 120.0;

  /// Throws InputError when the thresholds are not finite, positive and in order.
  void Validate() const;
};

/// Edge points of the pad's three contours, raw px.
struct PadContours {
  std::vector<Eigen::Vector2d> ring_outer, ring_inner, letter;
};

enum class Contour : std::uint8_t { kNone, kRingOuter, kRingInner, kLetter };

/// The contour to which an edge pixel (raw px) belongs, given the unit vector towards its bright side.
using ContourOf = std::function<Contour(const Eigen::Vector2d& pixel, const Eigen::Vector2d& to_bright)>;

/// Canny's edges in the patch around `ring_box`, which encloses the ring, sorted by `contour_of` (Sec. IV-B). With
/// ContourPoints::kSubpixel each point is moved along the gradient to its sub-pixel place. Pixels at the image border
/// are left out.
PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const ContourOf& contour_of,
                         const models::LandingPad& pad, const EdgeConfig& config = {});

/// The same; an edge pixel belongs to the contour near which it lies when the print is at `place` of the ring's plane.
PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const PadPlane& plane,
                         const TemplateWarp& place, const models::LandingPad& pad, const EdgeConfig& config = {});

}  // namespace touchdown::estimator::pad
