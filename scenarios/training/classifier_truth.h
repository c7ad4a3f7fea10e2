#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimator/paper/classifier.h"
#include "estimator/paper/components.h"
#include "scenarios/training/classifier_shapes.h"

namespace touchdown::training {

/// How far a component's box may lie from a shape's to be that shape.
struct TruthConfig {
  double edge_tolerance_px = 1.5;         ///< Of each edge, for the threshold and the pixel grid ...
  double edge_tolerance_fraction = 0.06;  ///< ... and this much of the shape's longer side.
  double min_ink = 0.7;                   ///< Component's pixels over the shape's ink: gaps, and things that cover it.
  double max_ink = 1.8;                   ///< Letters and rings a few pixels small come out fat.
  double min_white = 0.45;  ///< Of the white within the shape's hull that must be left: else its strokes have melted.
  double min_gap_px = 3.0;  ///< A shape whose white is narrower is not legible ...
  double max_obliquity_deg = 60.0;  ///< ... nor is one seen flatter.
  double unclear_overlap = 0.25;    ///< Overlap of the boxes from which a component that is no match is left out.
  double fragment_fraction = 0.4;   ///< A shape of which less is in the image is clutter: nobody could tell it.
};

/// The class of each component, from where the scene's rings and letters are known to be (the n-th of `shapes` appears
/// as the n-th of `projections`). nullopt where the truth is unclear: what is partly hidden, cut by the image's border,
/// or has melted together with its neighbors is in no set. `blur_px` is how far the image moved over its exposure.
std::vector<std::optional<estimator::paper::ComponentClass>> LabelComponents(
    const estimator::paper::ComponentSet& set, std::span<const GroundShape> shapes,
    std::span<const std::optional<ProjectedShape>> projections, const cv::Size& image, double blur_px,
    const TruthConfig& config = {});

}  // namespace touchdown::training
