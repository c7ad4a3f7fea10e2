#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "estimator/overlay.h"
#include "estimator/paper/classifier.h"
#include "estimator/paper/components.h"
#include "estimator/paper/reason.h"
#include "models/landing_pad.h"

namespace touchdown::estimator::paper {

/// Labels one component of a set: the network, or in tests the truth.
using ComponentClassifier = std::function<Classification(const ComponentSet&, const Component&)>;

struct PadDetectorConfig {
  /// How far the H's size over the ring's may leave the range that it has under an affine view, as a factor, for the
  /// perspective within the pad and for blur.
  double size_tolerance = 1.25;
  /// How far the centers of both boxes may lie apart, as a share of the ring's box: near and tilted, perspective moves
  /// them by up to (R / 2d) sin(tilt), 0.15 for R = 90 mm at d = 0.23 m and 50 degrees.
  double center_tolerance = 0.15;
  int most_candidates = 6;          ///< So many pairs are handed on.
  double pixel_tolerance_px = 1.5;  ///< Added to every bound: what a box is off by for being made of pixels.

  /// Throws InputError when size_tolerance is not at least 1, or another number is negative or not finite.
  void Validate() const;
};

/// A component's bounding box, and what it was classified as.
struct LabeledComponent {
  PixelBox box;
  ComponentClass label = ComponentClass::kOther;
  double probability = 0.0;  ///< Posterior of `label`.
};

/// The two parts of a landing pad in an image.
struct DetectedPad {
  Component ring;
  Component letter;
};

/// Finds the pad among the components of an image (Sec. IV-A.3 and IV-A.4).
class PadDetector {
 public:
  PadDetector(const models::LandingPad& pad, ComponentClassifier classify, const PadDetectorConfig& config = {});

  struct Result {
    /// What may be the pad, the likeliest first, or which stage failed: kNoComponent, kNoCircle, kNoH or kNoPair.
    std::variant<std::vector<DetectedPad>, Reason> outcome;
    std::vector<LabeledComponent> labeled;  ///< Every component, in the set's order.
  };

  /// A circle counts when it lies in the image whole: below the blind height "the circle is not fully visible"
  /// (Sec. VI-B.1). The pairs of a circle and an H that meet the geometric constraint, by the product of their
  /// posteriors, and of equal ones the one with the nearest centers first.
  Result Detect(const ComponentSet& components) const;

  /// The geometric constraint on two bounding boxes: the H's lies within the ring's, and its size and center are those
  /// that the pad's have under some view.
  bool MayBePad(const Component& ring, const Component& letter) const;

 private:
  ComponentClassifier classify_;
  PadDetectorConfig config_;
  double smallest_size_ratio_, largest_size_ratio_;
};

}  // namespace touchdown::estimator::paper
