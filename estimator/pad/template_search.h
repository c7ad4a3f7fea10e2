#pragma once

#include <array>
#include <optional>

#include "estimator/overlay.h"
#include "estimator/pad/conic_pose.h"
#include "estimator/pad/edges.h"
#include "estimator/pad/ellipse_detection.h"
#include "estimator/pad/ellipse_fit.h"
#include "estimator/pad/pad_plane.h"
#include "estimator/pad/pad_template_matcher.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// An image, one pixel of which is a square of pixels of the camera's.
struct DownsampledImage {
  models::ImageView image;
  DownsampledCamera view;
};

/// Means over squares of `n` by `n` px; what is left at the right and the bottom is cut off.
models::Image Shrunk(const models::ImageView& image, int n);

/// The box with every length times `n`.
PixelBox Scaled(const PixelBox& box, int n);

/// Points evenly spread over the ellipse's parameter.
std::vector<Eigen::Vector2d> PointsOn(const Ellipse& ellipse);

/// From raw pixels of a reduced image to undistorted pixels of the camera.
void Undistort(const DownsampledCamera& view, PadContours& contours);

/// A pad found in an image: its contours and their ellipses, undistorted px.
struct FoundPad {
  Ellipse ring_outer;
  std::optional<Ellipse> ring_inner;
  Ellipse letter;       ///< Fitted to the letter's contour, or to its outline as projected where the template lies.
  double stroke_angle;  ///< Direction of the H's long strokes in the normalized image, from +u towards +v, rad.
  PadContours contours;
  PixelBox ring_box;                     ///< Raw px of the camera.
  std::array<CirclePose, 2> ring_poses;  ///< The two pose hypotheses of ring_outer.
};

struct TemplateSearchConfig {
  EdgeConfig edges;
  RingFitConfig ring_fit;
  TemplateMatcherConfig print_match;
  RingSearchConfig ring_search;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// Finds a pad by its artwork: a ring, on whose plane the template of ring, letter and marks matches. Unlike connected
/// components it copes with glare, blur and shadows, which break or join what they should separate. No part of the
/// method of Yang et al.
class TemplateSearch {
 public:
  /// `camera`, `pad` and `config` must be valid.
  TemplateSearch(const models::CameraModel& camera, const models::LandingPad& pad, const TemplateSearchConfig& config);

  /// Detects ellipses in `searched`, matches the template on the planes of each, and measures the first match in
  /// `measured`, which shows the same at the same or a larger size. nullopt without a match.
  std::optional<FoundPad> ByEdges(const DownsampledImage& searched, const DownsampledImage& measured) const;

  /// The same for one ring, of which `ring_box` (px of `measured`) and both pose hypotheses are known.
  std::optional<FoundPad> WithinRing(const DownsampledImage& searched, const DownsampledImage& measured,
                                     const PixelBox& ring_box, const std::array<CirclePose, 2>& ring_poses) const;

  const PadTemplateMatcher& print_match() const { return print_; }

 private:
  std::optional<FoundPad> Measure(const DownsampledImage& seen, const PixelBox& ring_box, const PadPlane& plane,
                                  const TemplateWarp& place) const;
  std::optional<std::array<CirclePose, 2>> PosesOf(const Ellipse& ring) const;
  double StrokeAngle(const PadPlane& plane, const TemplateWarp& place) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  TemplateSearchConfig config_;
  PadTemplateMatcher print_;
};

}  // namespace touchdown::estimator::pad
