#pragma once

#include <array>
#include <string_view>

#include "models/landing_pad.h"

namespace touchdown::estimator::paper {

struct Component;
struct ComponentSet;

inline constexpr int kPatternSide = 14;
inline constexpr int kPatternSize = kPatternSide * kPatternSide;

/// Input of the network: kPatternSide rows of kPatternSide cells, from the top left. Each value is the fraction of the
/// cell that the component covers, in [0, 1].
using Pattern = std::array<float, kPatternSize>;

/// Classes of components (Sec. IV-A.3). kH is the letter of the pad, H or rectangle.
enum class ComponentClass { kCircle, kH, kOther };

/// Name of a class in files: "circle", "h" or "other".
std::string_view Name(ComponentClass label);

/// Output of the network for a component (Sec. IV-A.3).
struct Classification {
  ComponentClass label = ComponentClass::kOther;  ///< Class with the largest posterior.
  std::array<double, 3> posterior{};              ///< For kCircle, kH and kOther, in this order; sums to 1.
};

/// Pattern of a component of `set`: its dark pixels, without those of other components in its bounding box, resampled
/// from the bounding box to the pattern by area averaging.
Pattern PatternOf(const ComponentSet& set, const Component& component);

/// Classifies a pattern with the compiled-in 196-20-3 perceptron that was trained for this letter. It has logistic
/// hidden units and a softmax output (Sec. IV-A.3).
Classification Classify(const Pattern& pattern, models::PadLetter letter);

/// Classifies a component: Classify(PatternOf(set, component), letter).
Classification Classify(const ComponentSet& set, const Component& component, models::PadLetter letter);

}  // namespace touchdown::estimator::paper
