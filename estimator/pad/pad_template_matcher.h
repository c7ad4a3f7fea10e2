#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimator/pad/pad_plane.h"
#include "estimator/pad/rectified_disc.h"
#include "models/landing_pad.h"
#include "models/pad_outline.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// Where the print within a ring lies on the ring's plane: p_plane = offset + R(angle) diag(scale) p_W. Offset and
/// scale make up for paper that is not flat.
struct TemplateWarp {
  double angle = 0.0;  ///< Of W's X axis, from the plane's first coordinate's axis towards the second's.
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();

  Eigen::Vector2d OnPlane(const Eigen::Vector2d& p_W) const;
  Eigen::Vector2d OnTemplate(const Eigen::Vector2d& p_plane) const;
};

/// Shares, 0 to 1, of the H's parts that must be seen as described: dark or bright against the print around them.
/// Larger ones refuse an H under glare, smaller ones let other letters pass.
struct TemplateMatcherConfig {
  double least_ring = 0.75;  ///< Of the ring's circumference: of a square frame less is where a ring would be.
  double least_between_strokes =
      0.93;                       ///< Of the white above and of that below the bar: an N, M, X or 8 has black there.
  double least_bar = 0.5;         ///< Of the bar: a U or II has none.
  double least_rectangle = 0.85;  ///< Of a solid rectangle but for its corners: an H or a frame lacks a third of it.
  double least_stroke = 0.25;     ///< Of each of the four half strokes, or corners: glare may hide most of one,
  double least_strokes = 0.75;    ///< but of all four together only so much.
  double least_beside = 0.8;      ///< Of the white beside the H, where marks that nobody described may be.
  /// Least contrast of the H over that of the ring.
  double least_contrast = 0.2;

  /// Throws InputError when a share is not within (0, 1].
  void Validate() const;
};

/// Whether what lies within a ring is the print of the pad as described, letter and marks, and where: the geometric
/// constraint of Sec. IV-A.4 on gray values instead of boxes, on the plane that the ring's ellipse tells. It does not
/// ask that the letter hangs together: glare may break it, blur may join it with a mark.
class PadTemplateMatcher {
 public:
  /// `pad` and `config` must be valid.
  explicit PadTemplateMatcher(const models::LandingPad& pad, const TemplateMatcherConfig& config = {});

  /// Whether the print is at one of `places` on a ring's plane. The disc within the ring is rectified once for all.
  bool IsAt(const models::ImageView& image, const PadPlane& plane, std::span<const TemplateWarp> places) const;

  struct Found {
    TemplateWarp place;
    double zncc = -1.0;  ///< Correlation, at most 1, with what is seen.
  };

  /// Where on a ring's plane the print is; nullopt when what is seen there is not the print.
  std::optional<Found> Find(const models::ImageView& image, const PadPlane& plane) const;

 private:
  // How much of the H is as described at a place.
  struct Seen {
    double between_strokes = 0.0, bar = 0.0, stroke = 0.0, strokes = 0.0, beside = 0.0;  // As in the configuration.
    double contrast = 0.0;                                                               // Of 255.
  };
  struct SeenRing {
    double contrast = 0.0;  // Between the paper around the ring and the ring, of 255.
    double share = 0.0;     // Of the directions in which there is about as much.
  };
  // What is within a ring, if there is one.
  struct WithinRing {
    RectifiedDisc disc;
    double ring_contrast;
  };

  SeenRing RingAt(const models::ImageView& image, const PadPlane& plane) const;
  std::optional<WithinRing> Within(const models::ImageView& image, const PadPlane& plane) const;
  Seen At(const RectifiedDisc& disc, const TemplateWarp& place) const;
  bool Passes(const Seen& seen, double ring_contrast) const;
  double Zncc(const Cells& leveled, const RectifiedDisc& disc, const TemplateWarp& place, int stride) const;
  TemplateWarp Turned(const Cells& leveled, const RectifiedDisc& disc) const;
  Found Refined(const Cells& leveled, const RectifiedDisc& disc, const TemplateWarp& start) const;
  float BlackAt(const Cells& print, const Eigen::Vector2d& p_W) const;

  models::LandingPad pad_;
  models::PadOutline outline_;
  TemplateMatcherConfig config_;
  double reach_m_;         // Of the disc that is looked at.
  double white_m_;         // Of a circle of white within the ring.
  bool is_white_within_;   // No mark lies on that circle.
  Cells print_, blurred_;  // Black, 0 to 1, over the square around the ring's inner boundary.
};

}  // namespace touchdown::estimator::pad
