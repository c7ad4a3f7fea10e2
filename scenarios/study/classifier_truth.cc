#include "scenarios/study/classifier_truth.h"

#include <algorithm>
#include <cmath>

namespace touchdown::scenarios {
namespace {

using estimator::Component;
using estimator::FrameTrace;

enum class Match { kNone, kUnclear, kFragment, kShape };

/// The component's box in the same continuous coordinates as ProjectedShape::box.
cv::Rect2d BoxOf(const Component& component) {
  return {component.u - 0.5, component.v - 0.5, static_cast<double>(component.width),
          static_cast<double>(component.height)};
}

double OverlapOf(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double both = (a & b).area();
  return both / (a.area() + b.area() - both);
}

double LargestEdgeError(const cv::Rect2d& a, const cv::Rect2d& b) {
  return std::max(
      {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.br().x - b.br().x), std::abs(a.br().y - b.br().y)});
}

bool TouchesBorder(const Component& component, const cv::Size& image) {
  return component.u <= 0 || component.v <= 0 || component.u + component.width >= image.width ||
         component.v + component.height >= image.height;
}

Match MatchOf(const Component& component, const ProjectedShape& shape, const cv::Size& image, double blur_px,
              const TruthConfig& config) {
  if (shape.visible_box.empty()) return Match::kNone;
  const cv::Rect2d box = BoxOf(component);
  const bool whole = shape.visible_box.area() >= shape.box.area() * (1.0 - 1e-9);
  const double tolerance = config.edge_tolerance_px + 0.5 * blur_px +
                           config.edge_tolerance_share * std::max(shape.box.width, shape.box.height);
  const double ink = component.area / shape.ink_area;
  if (whole && !TouchesBorder(component, image) && LargestEdgeError(box, shape.box) <= tolerance &&
      ink >= config.least_ink && ink <= config.most_ink) {
    return Match::kShape;
  }
  const double overlap = OverlapOf(box, shape.visible_box);
  if (overlap < config.unclear_overlap) return Match::kNone;
  const double visible = shape.visible_box.area() / shape.box.area();
  return visible < config.fragment_share ? Match::kFragment : Match::kUnclear;
}

}  // namespace

std::vector<std::optional<FrameTrace::Label>> LabelComponents(
    const estimator::ComponentSet& set, std::span<const GroundShape> shapes,
    std::span<const std::optional<ProjectedShape>> projections, const cv::Size& image, double blur_px,
    const TruthConfig& config) {
  std::vector<std::optional<FrameTrace::Label>> labels;
  for (const Component& component : set.components) {
    std::optional<FrameTrace::Label> label = FrameTrace::Label::kOther;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Match match = projections[i] ? MatchOf(component, *projections[i], image, blur_px, config) : Match::kNone;
      if (match == Match::kUnclear) label.reset();
      if (match == Match::kShape) {
        label = shapes[i].label;
        break;
      }
    }
    labels.push_back(label);
  }
  return labels;
}

}  // namespace touchdown::scenarios
