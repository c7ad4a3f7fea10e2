#pragma once

#include <array>
#include <string_view>

#include "models/landing_pad.h"

namespace touchdown::estimator::paper {

struct Component;
struct ComponentSet;

inline constexpr int kPatternSide = 14;
inline constexpr int kPatternSize = kPatternSide * kPatternSide;

/// What the network sees of a component: kPatternSide rows of kPatternSide cells, from the top left, each the share of
/// the cell that the component covers, in [0, 1].
using Pattern = std::array<float, kPatternSize>;

/// The classes of components (Sec. IV-A.3).
enum class ComponentClass { kCircle, kH, kOther };

/// "circle", "h" or "other".
std::string_view Name(ComponentClass label);

/// What the network says of a component (Sec. IV-A.3).
struct Classification {
  ComponentClass label = ComponentClass::kOther;  ///< The class of the largest posterior.
  std::array<double, 3> posterior{};  ///< Of kCircle, kH (the pad's letter) and kOther, in this order; sums to 1.
};

/// The component's own dark pixels, without those of other components in its bounding box, stretched from the bounding
/// box to the pattern by area averaging. `component` is one of `set`'s.
Pattern PatternOf(const ComponentSet& set, const Component& component);

/// The compiled-in 196-20-3 perceptron that was trained on pads of this letter: logistic hidden units, softmax output
/// (Sec. IV-A.3).
Classification Classify(const Pattern& pattern, models::PadLetter letter);

/// Classify(PatternOf(set, component), letter).
Classification Classify(const ComponentSet& set, const Component& component, models::PadLetter letter);

}  // namespace touchdown::estimator::paper
