#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/paper/components.h"
#include "estimator/paper/pad_detector.h"
#include "estimator/paper/paper_options.h"
#include "estimator/paper/print_match.h"
#include "estimator/paper/seen_plane.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::estimator {

struct EdgeConfig {
  ContourPoints contour_points = ContourPoints::kSubpixel;
  /// Canny's thresholds on Sobel's gradient (3x3; four times the grey values' difference over two pixels). Lower ones
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

/// Canny's edges on the grey patch around the pad, told apart: an edge pixel belongs to the component that lies on its
/// dark side; on the ring it is on the outer boundary where the bright side is outwards (Sec. IV-B). With
/// ContourPoints::kSubpixel each point is moved along the gradient to its sub-pixel place. Pixels at the image's border
/// are left out.
PadContours FindContours(const models::ImageView& image, const ComponentSet& components, const DetectedPad& detected,
                         const models::LandingPad& pad, const EdgeConfig& config = {});

/// The same where the components are not those of the pad: an edge pixel belongs to the contour near which it lies when
/// the print is at `place` of the ring's plane. `ring_box` encloses the ring.
PadContours FindContours(const models::ImageView& image, const PixelBox& ring_box, const SeenPlane& plane,
                         const PrintPlace& place, const models::LandingPad& pad, const EdgeConfig& config = {});

}  // namespace touchdown::estimator
