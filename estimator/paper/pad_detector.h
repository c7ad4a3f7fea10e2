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

/// Function that classifies one component of a set: the network, or the truth in tests.
using ComponentClassifier = std::function<Classification(const ComponentSet&, const Component&)>;

/// Settings of PadDetector.
struct PadDetectorConfig {
  /// Factor by which the ratio of letter size to ring size may leave its range under an affine projection, to allow for
  /// perspective within the pad and for blur. Larger values accept more pairs.
  double size_tolerance = 1.25;
  /// Largest offset between the centers of both bounding boxes, as a fraction of the ring's box. At close range
  /// perspective shifts them by up to (R / 2d) sin(tilt): 0.15 for R = 90 mm, d = 0.23 m and 50 degrees.
  double center_tolerance = 0.15;
  int max_candidates = 6;           ///< Largest number of pairs that Detect returns.
  double pixel_tolerance_px = 1.5;  ///< Added to every limit, for the discretization of the boxes.

  /// Throws InputError unless size_tolerance is finite and at least 1, max_candidates is at least 1, and the other
  /// values are finite and not negative.
  void Validate() const;
};

/// Bounding box of a component and its class.
struct LabeledComponent {
  PixelBox box;
  ComponentClass label = ComponentClass::kOther;
  double probability = 0.0;  ///< Posterior of `label`.
};

/// Components of a landing pad in an image.
struct DetectedPad {
  Component ring;
  Component letter;
};

/// Finds the pad among the components of an image (Sec. IV-A.3 and IV-A.4).
class PadDetector {
 public:
  PadDetector(const models::LandingPad& pad, ComponentClassifier classify, const PadDetectorConfig& config = {});

  struct Result {
    /// Candidates for the pad, the most probable first, or the step that failed: kNoComponent, kNoCircle, kNoH or
    /// kNoPair.
    std::variant<std::vector<DetectedPad>, Reason> outcome;
    std::vector<LabeledComponent> labeled;  ///< Every component, in the order of the set.
  };

  /// Returns the pairs of a circle and an H that satisfy the geometric constraint. Circles cut by the image border are
  /// ignored: below the blind height "the circle is not fully visible" (Sec. VI-B.1). Pairs are sorted by decreasing
  /// product of their posteriors, and pairs of equal product by increasing distance between the centers.
  Result Detect(const ComponentSet& components) const;

  /// Whether two bounding boxes satisfy the geometric constraint: the box of the letter is within the box of the ring,
  /// and its size and center are possible for some view of the pad.
  bool IsPossiblePad(const Component& ring, const Component& letter) const;

 private:
  ComponentClassifier classify_;
  PadDetectorConfig config_;
  double min_size_ratio_, max_size_ratio_;
};

}  // namespace touchdown::estimator::paper
