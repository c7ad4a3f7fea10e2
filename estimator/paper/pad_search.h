#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "estimator/estimator.h"
#include "estimator/pad/edges.h"
#include "estimator/pad/ellipse_fit.h"
#include "estimator/pad/print_match.h"
#include "estimator/pad/ring_search.h"
#include "estimator/pad/seen_plane.h"
#include "estimator/pad/undistort_table.h"
#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "estimator/paper/letter_ellipse.h"
#include "estimator/paper/pad_contours.h"
#include "estimator/paper/pad_detector.h"
#include "models/camera_model.h"

namespace touchdown::estimator::paper {

/// The settings of Secs. IV-A and IV-B.
struct PadSearchConfig {
  BinarizeConfig binarize;
  ComponentsConfig components;
  PadDetectorConfig pad_detector;
  pad::EdgeConfig edges;
  pad::RingFitConfig ring_fit;
  pad::PrintMatchConfig print_match;
  pad::RingSearchConfig ring_search;

  /// Throws InputError when a setting is impossible.
  void Validate() const;
};

/// The pad's contours and their ellipses, undistorted px. Where the letter is no component of its own, its ellipse is
/// that of the described outline where the print was found.
struct FoundPad {
  pad::Ellipse ring_outer;
  std::optional<pad::Ellipse> ring_inner;
  pad::Ellipse letter;
  double stroke_angle;  ///< In the normalized image.
  pad::PadContours contours;
  PixelBox ring_box;  ///< Raw px.
};

/// Finds the pad in an image. First as the paper does: binarization, components, classification and geometric
/// constraint (Sec. IV-A), then edges and ellipses (Sec. IV-B). Where components show no pad, because glare, blur or
/// shadows break or join what the classifier would know, the ring is sought among the edges of the image. In both ways
/// a ring is the pad's only if the print within it is the described one.
class PadSearch {
 public:
  /// `camera`, `pad` and `config` must be valid. `on_stage` is EstimatorSetup's.
  PadSearch(const models::CameraModel& camera, const models::LandingPad& pad, ComponentClassifier classify,
            FrameOrder frame_order, const PadSearchConfig& config, std::function<void(FrameStage)> on_stage = nullptr);

  struct Result {
    std::optional<FoundPad> pad;
    /// The stage at which the components' way failed; without meaning with a pad.
    FrameStatus failed = FrameStatus::kNoComponent;
    std::vector<FrameTrace::Component> labelled;  ///< Without those of the pad where its edges showed it.
  };

  Result Find(const models::ImageView& image) const;

 private:
  /// An image in which one pixel is a square of so many pixels of the camera.
  struct Reduced {
    models::ImageView image;
    pad::ReducedView view;
  };

  void Enter(FrameStage stage) const {
    if (on_stage_) on_stage_(stage);
  }
  Result ByComponents(const Reduced& seen) const;
  std::optional<FoundPad> Fit(const Reduced& seen, const ComponentSet& components, const DetectedPad& detected) const;
  std::optional<FoundPad> ByEdges(const Reduced& searched, const Reduced& measured) const;
  std::optional<FoundPad> ByPrint(const Reduced& searched, const Reduced& measured, const PixelBox& ring_box,
                                  const std::array<pad::CirclePose, 2>& ring_poses) const;
  std::optional<FoundPad> Measure(const Reduced& seen, const PixelBox& ring_box, const pad::SeenPlane& plane,
                                  const pad::PrintPlace& place) const;
  bool IsPrintUnder(const pad::Ellipse& normalized_letter, const Reduced& seen, const pad::CirclePose& ring_pose) const;
  void Undistort(const pad::ReducedView& view, pad::PadContours& contours) const;
  pad::Ellipse Undistorted(const pad::Ellipse& raw, const pad::ReducedView& view) const;
  double StrokeAngle(const pad::SeenPlane& plane, const pad::PrintPlace& place, const pad::Ellipse& letter) const;

  models::CameraModel camera_;
  models::LandingPad pad_;
  PadSearchConfig config_;
  pad::UndistortTable undistort_;
  LetterEllipse letter_;
  PadDetector detector_;
  pad::PrintMatch print_;
  bool searches_edges_;
  std::function<void(FrameStage)> on_stage_;
  int reduction_;  // Of large images.
};

}  // namespace touchdown::estimator::paper
