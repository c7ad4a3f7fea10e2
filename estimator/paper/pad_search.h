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

/// Settings of PadSearch (Secs. IV-A and IV-B).
struct PadSearchConfig {
  BinarizeConfig binarize;
  ComponentsConfig components;
  PadDetectorConfig pad_detector;
  pad::EdgeConfig edges;
  pad::RingFitConfig ring_fit;
  Verify verify = Verify::kTemplate;
  pad::TemplateMatcherConfig template_matcher;
  pad::EllipseDetectionConfig ellipse_detection;

  /// Throws InputError when a setting is invalid.
  void Validate() const;
};

/// Finds the pad in an image with the method of Yang et al.: binarization, components, classification and geometric
/// constraint (Sec. IV-A), then edges and ellipses (Sec. IV-B).
///
/// With Verify::kTemplate a pair of components is accepted only if the template matches. If the letter's component does
/// not match, the template is searched within the ring and provides the contours. If the components contain no pad, the
/// edges of the image are searched for a ring, except in flight.
class PadSearch {
 public:
  /// `camera`, `pad` and `config` must be valid. `on_stage` is described at EstimatorSetup. Throws InputError for
  /// Verify::kNone with a letter about as wide as high, whose ellipse has no direction.
  PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
            FrameOrder frame_order, const PadSearchConfig& config, std::function<void(FrameStage)> on_stage = nullptr);

  struct Result {
    std::optional<pad::FoundPad> pad;
    /// Step at which the search by components failed; undefined when `pad` is set.
    Reason failed = Reason::kNoComponent;
    std::vector<LabeledComponent> labeled;  ///< All classified components, even if the pad was found by its edges.
  };

  /// Searches an image of the camera's size.
  Result Find(const models::ImageView& image) const;

 private:
  void Enter(FrameStage stage) const {
    if (on_stage_) on_stage_(stage);
  }
  Result FindByComponents(const pad::DownsampledImage& input) const;
  std::optional<pad::FoundPad> Fit(const pad::DownsampledImage& input, const ComponentSet& components,
                                   const DetectedPad& detected) const;
  std::optional<pad::FoundPad> FindByEdges(const pad::DownsampledImage& nominal) const;
  bool TemplateMatches(const pad::Ellipse& normalized_letter, const pad::DownsampledImage& input,
                       const pad::CirclePose& ring_pose) const;
  std::optional<pad::FoundPad> WithLetterDirection(std::optional<pad::FoundPad> pad) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  PadSearchConfig config_;
  pad::UndistortTable undistort_;
  LetterEllipse letter_;
  PadDetector detector_;
  std::optional<pad::TemplateSearch> template_;  // Set for Verify::kTemplate.
  bool searches_edges_;
  std::function<void(FrameStage)> on_stage_;
  int reduction_;  // Downsampling factor, above 1 for large images.
};

}  // namespace touchdown::estimator::paper
