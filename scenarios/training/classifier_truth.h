#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimator/paper/classifier.h"
#include "estimator/paper/components.h"
#include "scenarios/training/classifier_shapes.h"

namespace touchdown::training {

/// Criteria for matching a component with a projected shape.
struct TruthConfig {
  /// Tolerance of each edge of the box: this constant, half the blur, and edge_tolerance_fraction of its longer side.
  double edge_tolerance_px = 1.5;
  double edge_tolerance_fraction = 0.06;
  double min_ink = 0.7;     ///< Minimum area of the component divided by the ink area of the shape.
  double max_ink = 1.8;     ///< Maximum of the same ratio; the strokes of small shapes become thicker.
  double min_white = 0.45;  ///< Minimum remaining fraction of the white in the hull; below it the strokes have merged.
  double min_gap_px = 3.0;  ///< A shape whose gap is smaller than this plus the blur is unclear.
  double max_obliquity_deg = 60.0;  ///< A shape at a larger obliquity is unclear.
  /// A component that overlaps a shape at least this much (IoU of the boxes), but does not match it, is unclear.
  double unclear_overlap = 0.25;
  double fragment_fraction = 0.4;  ///< A shape with a smaller visible fraction of its box is clutter.
};

/// True class of each component, from the known projections of the rings and letters of the scene. `projections` has
/// one element per element of `shapes`. nullopt when the class is unclear: the shape is partly occluded, cut by the
/// image border, or merged with its neighbors; such components are not used. `blur_px` is the blur of the image: motion
/// during the exposure plus defocus.
std::vector<std::optional<estimator::paper::ComponentClass>> LabelComponents(
    const estimator::paper::ComponentSet& set, std::span<const GroundShape> shapes,
    std::span<const std::optional<ProjectedShape>> projections, const cv::Size& image, double blur_px,
    const TruthConfig& config = {});

}  // namespace touchdown::training
