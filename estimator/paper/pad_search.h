#pragma once

#include <optional>
#include <vector>

#include "estimator/estimator.h"
#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "estimator/paper/edges.h"
#include "estimator/paper/ellipse_fit.h"
#include "estimator/paper/letter_check.h"
#include "estimator/paper/letter_ellipse.h"
#include "estimator/paper/pad_detector.h"
#include "estimator/paper/undistort_table.h"
#include "models/camera_model.h"

namespace touchdown::estimator {

/// The settings of Secs. IV-A and IV-B.
struct PadSearchConfig {
  BinarizeConfig binarize;
  ComponentsConfig components;
  PadDetectorConfig pad_detector;
  EdgeConfig edges;
  LetterCheckConfig letter_check;
  RingFitConfig ring_fit;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// The pad's contours and their ellipses, undistorted px.
struct FoundPad {
  Ellipse ring_outer;
  std::optional<Ellipse> ring_inner;
  Ellipse letter;
  double stroke_angle;  ///< In the normalized image.
  PadContours contours;
  PixelBox ring_box;  ///< Raw px.
};

/// Finds the pad in an image: binarization, components, classification and geometric constraint (Sec. IV-A), then edges
/// and ellipses (Sec. IV-B). Where the first look at the image shows no pad, it looks again in other ways: coarser, at
/// which blur and noise vanish and broad strokes fit the threshold's window; with a smaller window, which follows
/// shadows; finer, where the image is large. What any look finds must pass the same checks.
class PadSearch {
 public:
  /// `camera`, `pad` and `config` must be valid.
  PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
            const PadSearchConfig& config);

  struct Result {
    std::optional<FoundPad> pad;
    FrameStatus failed =
        FrameStatus::kNoComponent;  ///< The stage at which the first look failed; without meaning with a pad.
    std::vector<FrameTrace::Component> labelled;  ///< Of the look that found the pad, or else of the first.
  };

  Result Find(const models::ImageView& image) const;

 private:
  /// A way to look at the image.
  struct Look {
    int reduction = 1;  ///< Side, px, of the square of which one pixel is made.
    BinarizeConfig binarize;
    PadDetector detector;
  };

  Result FindBy(const Look& look, const models::ImageView& image) const;
  std::optional<FoundPad> Fit(const Look& look, const models::ImageView& reduced, const ComponentSet& components,
                              const DetectedPad& detected) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  PadSearchConfig config_;
  UndistortTable undistort_;
  LetterEllipse letter_;
  LetterCheck letter_check_;
  std::vector<Look> looks_;
};

}  // namespace touchdown::estimator
