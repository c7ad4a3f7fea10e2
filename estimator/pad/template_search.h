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

/// Image of which each pixel is the mean of a square of camera pixels.
struct DownsampledImage {
  models::ImageView image;
  DownsampledCamera view;
};

/// The image downsampled by `n`: means over squares of `n` x `n` px. Remaining columns and rows at the right and bottom
/// are dropped.
models::Image Downsampled(const models::ImageView& image, int n);

/// The box with position and size multiplied by `n`.
PixelBox Scaled(const PixelBox& box, int n);

/// Points on the ellipse at uniform steps of its parameter angle.
std::vector<Eigen::Vector2d> PointsOn(const Ellipse& ellipse);

/// Converts contours from raw pixels of a downsampled image to undistorted camera pixels.
void Undistort(const DownsampledCamera& view, PadContours& contours);

/// A pad detected in an image: its contours and their ellipses, undistorted px.
struct FoundPad {
  Ellipse ring_outer;
  std::optional<Ellipse> ring_inner;
  Ellipse letter;       ///< Fitted to the letter's contour, or to the outline of the matched template.
  double stroke_angle;  ///< Direction of the H's long strokes in the normalized image, from +u towards +v, rad.
  PadContours contours;
  PixelBox ring_box;                     ///< Raw px of the camera.
  std::array<CirclePose, 2> ring_poses;  ///< The two pose hypotheses of ring_outer.
};

/// Settings of TemplateSearch.
struct TemplateSearchConfig {
  EdgeConfig edges;
  RingFitConfig ring_fit;
  TemplateMatcherConfig template_matcher;
  EllipseDetectionConfig ellipse_detection;

  /// Throws InputError when a setting is invalid.
  void Validate() const;
};

/// Finds a pad by its artwork: a ring on whose plane the template of ring, letter and markings matches. Unlike a search
/// by connected components it is robust to glare, blur and shadows, which split or join components. It is not part of
/// the method of Yang et al.
class TemplateSearch {
 public:
  /// `camera`, `pad` and `config` must be valid.
  TemplateSearch(const models::CameraModel& camera, const models::LandingPad& pad, const TemplateSearchConfig& config);

  /// Detects ellipses in `searched`, matches the template on the two planes of each, and measures the first match in
  /// `measured`, which is the same image at the same or a higher resolution. nullopt without a match.
  std::optional<FoundPad> FindByEdges(const DownsampledImage& searched, const DownsampledImage& measured) const;

  /// Same as FindByEdges, but for one ring with known bounding box (px of `measured`) and pose hypotheses.
  std::optional<FoundPad> FindWithinRing(const DownsampledImage& searched, const DownsampledImage& measured,
                                         const PixelBox& ring_box, const std::array<CirclePose, 2>& ring_poses) const;

  const PadTemplateMatcher& template_matcher() const { return matcher_; }

 private:
  std::optional<FoundPad> Measure(const DownsampledImage& input, const PixelBox& ring_box, const PadPlane& plane,
                                  const TemplateWarp& warp) const;
  std::optional<std::array<CirclePose, 2>> PosesOf(const Ellipse& ring) const;
  double StrokeAngle(const PadPlane& plane, const TemplateWarp& warp) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  TemplateSearchConfig config_;
  PadTemplateMatcher matcher_;
};

}  // namespace touchdown::estimator::pad
