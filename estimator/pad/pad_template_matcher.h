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

/// Map from the pad template to the ring's plane: p_plane = offset + R(angle) diag(scale) p_W. Offset and scale
/// compensate for paper that is not flat.
struct TemplateWarp {
  double angle = 0.0;  ///< Angle of W's X axis, from the plane's first coordinate axis towards the second, rad.
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();

  /// The point of the plane, m, for a point of the template, m.
  Eigen::Vector2d OnPlane(const Eigen::Vector2d& p_W) const;
  /// The point of the template, m, for a point of the plane, m.
  Eigen::Vector2d OnTemplate(const Eigen::Vector2d& p_plane) const;
};

/// Smallest fractions, 0 to 1, of the cells of each part that must be as the template has them, dark or bright. Larger
/// values reject more letters with glare; smaller values accept more letters that are not the described one.
struct TemplateMatcherConfig {
  double min_ring = 0.75;             ///< Ring, as a fraction of its circumference: a square frame covers less.
  double min_between_strokes = 0.93;  ///< White above and white below the bar: N, M, X and 8 have black there.
  double min_bar = 0.5;               ///< Bar of the H: U and II have none.
  double min_rectangle = 0.85;        ///< Solid rectangle without its corners: an H or a frame lacks a third of it.
  double min_stroke = 0.25;           ///< Each of the four half strokes, or corners: glare may hide most of one.
  double min_strokes = 0.75;          ///< All four half strokes, or corners, on average.
  double min_beside = 0.8;            ///< White beside the letter, where undescribed markings may be.
  double min_contrast = 0.2;          ///< Contrast of the letter, relative to the contrast of the ring.

  /// Throws InputError unless every value is above 0 and at most 1.
  void Validate() const;
};

/// Matches the artwork of the described pad, letter and markings, within a ring.
///
/// This is the geometric constraint of Sec. IV-A.4 on gray values instead of bounding boxes, on the plane that follows
/// from the ring's ellipse. The letter need not be one connected component: glare may break it, and blur may join it
/// with a marking.
class PadTemplateMatcher {
 public:
  /// `pad` and `config` must be valid.
  explicit PadTemplateMatcher(const models::LandingPad& pad, const TemplateMatcherConfig& config = {});

  /// Whether the template matches at one of `warps` on the ring's plane.
  bool MatchesAt(const models::ImageView& image, const PadPlane& plane, std::span<const TemplateWarp> warps) const;

  struct Match {
    TemplateWarp warp;
    double zncc = -1.0;  ///< Zero-mean normalized cross-correlation of image and template, -1 to 1.
  };

  /// Finds the warp at which the template matches on the ring's plane; nullopt without a match.
  std::optional<Match> Find(const models::ImageView& image, const PadPlane& plane) const;

 private:
  // Fractions of the letter's parts that agree with the template at a warp.
  struct PartScores {
    double between_strokes = 0.0, bar = 0.0, stroke = 0.0, strokes = 0.0, beside = 0.0;  // See TemplateMatcherConfig.
    double contrast = 0.0;                                                               // 0 to 255.
  };
  struct RingScore {
    double contrast = 0.0;  // Difference between the paper next to the ring and the ring, 0 to 255.
    double fraction = 0.0;  // Fraction of the directions with about this contrast.
  };
  // The rectified interior of a ring.
  struct RingInterior {
    RectifiedDisc disc;
    double ring_contrast;
  };

  RingScore ScoreRing(const models::ImageView& image, const PadPlane& plane) const;
  std::optional<RingInterior> RectifyInterior(const models::ImageView& image, const PadPlane& plane) const;
  PartScores ScoreParts(const RectifiedDisc& disc, const TemplateWarp& warp) const;
  bool Passes(const PartScores& scores, double ring_contrast) const;
  double Zncc(const Cells& normalized, const RectifiedDisc& disc, const TemplateWarp& warp, int stride) const;
  TemplateWarp CoarseOrientation(const Cells& normalized, const RectifiedDisc& disc) const;
  Match RefineWarp(const Cells& normalized, const RectifiedDisc& disc, const TemplateWarp& start) const;
  float BlackAt(const Cells& texture, const Eigen::Vector2d& p_W) const;

  models::LandingPad pad_;
  models::PadOutline outline_;
  TemplateMatcherConfig config_;
  double disc_radius_m_;               // Radius of the rectified disc.
  double white_radius_m_;              // Radius of a circle within the ring at which the white is measured.
  bool is_white_circle_;               // Whether that circle is free of black.
  Cells template_, blurred_template_;  // Black, 0 to 1, over the bounding square of the ring's inner circle.
};

}  // namespace touchdown::estimator::pad
