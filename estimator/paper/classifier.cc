#include "estimator/paper/classifier.h"

#include <algorithm>
#include <stdexcept>

#include "estimator/paper/classifier_weights.h"
#include "estimator/paper/components.h"

namespace touchdown::estimator::paper {
namespace {

/// Adds to every cell `weight` times the fraction of it that [begin, end), in cells, covers.
void AddSpan(float begin, float end, float weight, float* cells) {
  const int first = static_cast<int>(begin);
  const int last = std::min(static_cast<int>(end), kPatternSide - 1);
  if (first == last) {
    cells[first] += weight * (end - begin);
    return;
  }
  cells[first] += weight * (static_cast<float>(first + 1) - begin);
  for (int i = first + 1; i < last; ++i) cells[i] += weight;
  cells[last] += weight * (end - static_cast<float>(last));
}

}  // namespace

std::string_view Name(ComponentClass label) {
  switch (label) {
    case ComponentClass::kCircle:
      return "circle";
    case ComponentClass::kH:
      return "h";
    case ComponentClass::kOther:
      return "other";
  }
  throw std::logic_error("unknown component class");
}

Pattern PatternOf(const ComponentSet& set, const Component& component) {
  Pattern pattern{};
  const float cells_per_column = static_cast<float>(kPatternSide) / static_cast<float>(component.width);
  const float cells_per_row = static_cast<float>(kPatternSide) / static_cast<float>(component.height);
  for (const Run& run : set.RunsOf(component)) {
    const float left = static_cast<float>(run.u_begin - component.u) * cells_per_column;
    const float right = static_cast<float>(run.u_end - component.u) * cells_per_column;
    const float top = static_cast<float>(run.v - component.v) * cells_per_row;
    const float bottom = static_cast<float>(run.v - component.v + 1) * cells_per_row;
    for (int row = static_cast<int>(top); row < kPatternSide && static_cast<float>(row) < bottom; ++row) {
      const float weight = std::min(bottom, static_cast<float>(row + 1)) - std::max(top, static_cast<float>(row));
      AddSpan(left, right, weight, &pattern[static_cast<std::size_t>(row * kPatternSide)]);
    }
  }
  return pattern;
}

Classification Classify(const Pattern& pattern, models::PadLetter letter) {
  const auto posteriors =
      letter == models::PadLetter::kRectangle ? TouchdownRectangleClassifierPosteriors : TouchdownClassifierPosteriors;
  std::array<float, 3> posterior{};
  posteriors(pattern.data(), posterior.data());
  Classification result;
  std::copy(posterior.begin(), posterior.end(), result.posterior.begin());
  const auto best = std::max_element(posterior.begin(), posterior.end()) - posterior.begin();
  result.label = static_cast<ComponentClass>(best);
  return result;
}

Classification Classify(const ComponentSet& set, const Component& component, models::PadLetter letter) {
  return Classify(PatternOf(set, component), letter);
}

}  // namespace touchdown::estimator::paper
