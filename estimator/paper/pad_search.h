#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "estimator/estimator_setup.h"
#include "estimator/pad/ellipse_fit.h"
#include "estimator/pad/template_search.h"
#include "estimator/pad/undistort_table.h"
#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "estimator/paper/letter_ellipse.h"
#include "estimator/paper/pad_contours.h"
#include "estimator/paper/pad_detector.h"
#include "estimator/paper/paper_options.h"
#include "models/camera_model.h"

namespace touchdown::estimator::paper {

/// The settings of Secs. IV-A and IV-B.
struct PadSearchConfig {
  BinarizeConfig binarize;
  ComponentsConfig components;
  PadDetectorConfig pad_detector;
  pad::EdgeConfig edges;
  pad::RingFitConfig ring_fit;
  Verify verify = Verify::kTemplate;
  pad::TemplateMatcherConfig print_match;
  pad::RingSearchConfig ring_search;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// Finds the pad in an image as the paper does: binarization, components, classification and geometric constraint (Sec.
/// IV-A), then edges and ellipses (Sec. IV-B).
///
/// With Verify::kTemplate a pair of components is the pad only where its artwork matches the template. Where the ring
/// matches but the letter's component does not, the template gives the contours; and where components show no pad at
/// all, the edges of the image are searched for a ring, except in flight.
class PadSearch {
 public:
  /// `camera`, `pad` and `config` must be valid. `on_stage` is EstimatorSetup's. Throws InputError for Verify::kNone
  /// with an H as wide as high, whose ellipse has no direction.
  PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
            FrameOrder frame_order, const PadSearchConfig& config, std::function<void(FrameStage)> on_stage = nullptr);

  struct Result {
    std::optional<pad::FoundPad> pad;
    /// The step at which the search by components failed; without meaning with a pad.
    Reason failed = Reason::kNoComponent;
    std::vector<LabeledComponent> labeled;  ///< Without those of the pad where its edges showed it.
  };

  Result Find(const models::ImageView& image) const;

 private:
  void Enter(FrameStage stage) const {
    if (on_stage_) on_stage_(stage);
  }
  Result ByComponents(const pad::DownsampledImage& seen) const;
  std::optional<pad::FoundPad> Fit(const pad::DownsampledImage& seen, const ComponentSet& components,
                                   const DetectedPad& detected) const;
  std::optional<pad::FoundPad> ByEdges(const pad::DownsampledImage& usual) const;
  bool IsTemplateUnder(const pad::Ellipse& normalized_letter, const pad::DownsampledImage& seen,
                       const pad::CirclePose& ring_pose) const;
  std::optional<pad::FoundPad> WithLetterDirection(std::optional<pad::FoundPad> pad) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  PadSearchConfig config_;
  pad::UndistortTable undistort_;
  LetterEllipse letter_;
  PadDetector detector_;
  std::optional<pad::TemplateSearch> template_;  // With Verify::kTemplate.
  bool searches_edges_;
  std::function<void(FrameStage)> on_stage_;
  int reduction_;  // Of large images.
};

}  // namespace touchdown::estimator::paper
