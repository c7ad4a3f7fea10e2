#include "scenarios/training/classifier_truth.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"

namespace touchdown::training {
namespace {

using estimator::paper::Component;
using estimator::paper::ComponentClass;
using estimator::paper::ComponentSet;

enum class Match { kNone, kUnclear, kFragment, kShape };

/// Bounding box of a component in the coordinates of ProjectedShape::box.
cv::Rect2d ComponentBox(const Component& component) {
  return {component.u - 0.5, component.v - 0.5, static_cast<double>(component.width),
          static_cast<double>(component.height)};
}

double IntersectionOverUnion(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double both = (a & b).area();
  return both / (a.area() + b.area() - both);
}

double MaxEdgeError(const cv::Rect2d& a, const cv::Rect2d& b) {
  return std::max(
      {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.br().x - b.br().x), std::abs(a.br().y - b.br().y)});
}

bool TouchesBorder(const Component& component, const cv::Size& image) {
  return component.u <= 0 || component.v <= 0 || component.u + component.width >= image.width ||
         component.v + component.height >= image.height;
}

/// Returns whether the areas of ink and of enclosed white (if any) match the shape.
bool HasExpectedInk(const Component& component, const ProjectedShape& shape, const TruthConfig& config) {
  const double ink = component.area / shape.ink_area;
  const double white_area = shape.hull_area - shape.ink_area;
  const bool has_white = white_area <= 0.0 || (shape.hull_area - component.area) / white_area >= config.min_white;
  return ink >= config.min_ink && ink <= config.max_ink && has_white;
}

/// Returns whether the central ninth of the component's box is almost free of its pixels. This holds for a ring that
/// has not merged with the letter inside.
bool IsHollow(const ComponentSet& set, const Component& component) {
  const int left = component.u + component.width / 3, right = component.u + component.width - component.width / 3;
  const int top = component.v + component.height / 3, bottom = component.v + component.height - component.height / 3;
  int inside = 0;
  for (const estimator::paper::Run& run : set.RunsOf(component)) {
    if (run.v >= top && run.v < bottom) inside += std::max(0, std::min(run.u_end, right) - std::max(run.u_begin, left));
  }
  return inside <= 0.1 * (right - left) * (bottom - top);
}

bool IsLegible(const ProjectedShape& shape, double blur_px, const TruthConfig& config) {
  return shape.gap >= config.min_gap_px + blur_px && shape.obliquity <= models::DegToRad(config.max_obliquity_deg);
}

Match MatchComponent(const Component& component, const ProjectedShape& shape, const cv::Size& image, double blur_px,
                     const TruthConfig& config) {
  if (shape.visible_box.empty()) return Match::kNone;
  const cv::Rect2d box = ComponentBox(component);
  const bool is_whole = shape.visible_box.area() >= shape.box.area() * (1.0 - 1e-9);
  const double tolerance = config.edge_tolerance_px + 0.5 * blur_px +
                           config.edge_tolerance_fraction * std::max(shape.box.width, shape.box.height);
  if (is_whole && !TouchesBorder(component, image) && MaxEdgeError(box, shape.box) <= tolerance &&
      HasExpectedInk(component, shape, config)) {
    return IsLegible(shape, blur_px, config) ? Match::kShape : Match::kUnclear;
  }
  const double overlap = IntersectionOverUnion(box, shape.visible_box);
  if (overlap < config.unclear_overlap) return Match::kNone;
  const double visible = shape.visible_box.area() / shape.box.area();
  return visible < config.fragment_fraction ? Match::kFragment : Match::kUnclear;
}

}  // namespace

std::vector<std::optional<ComponentClass>> LabelComponents(const ComponentSet& set, std::span<const GroundShape> shapes,
                                                           std::span<const std::optional<ProjectedShape>> projections,
                                                           const cv::Size& image, double blur_px,
                                                           const TruthConfig& config) {
  std::vector<std::optional<ComponentClass>> labels;
  for (const Component& component : set.components) {
    std::optional<ComponentClass> label = ComponentClass::kOther;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Match match =
          projections[i] ? MatchComponent(component, *projections[i], image, blur_px, config) : Match::kNone;
      if (match == Match::kUnclear) label.reset();
      if (match == Match::kShape) {
        const bool merged = shapes[i].label == ComponentClass::kCircle && !IsHollow(set, component);
        label = merged ? std::nullopt : std::optional(shapes[i].label);
        break;
      }
    }
    labels.push_back(label);
  }
  return labels;
}

}  // namespace touchdown::training
