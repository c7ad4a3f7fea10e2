#include "estimator/paper/pad_detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

struct Candidate {
  const Component* component;
  double posterior;
};

double PosteriorOf(const Classification& classification, ComponentClass label) {
  return classification.posterior[static_cast<std::size_t>(label)];
}

/// Vector from the center of b's bounding box to the center of a's, px.
Eigen::Vector2d CenterOffset(const Component& a, const Component& b) {
  return 0.5 * Eigen::Vector2d(2 * a.u + a.width - 2 * b.u - b.width, 2 * a.v + a.height - 2 * b.v - b.height);
}

}  // namespace

void PadDetectorConfig::Validate() const {
  if (!std::isfinite(size_tolerance) || size_tolerance < 1.0) {
    throw InputError("size_tolerance must be finite and at least 1");
  }
  if (max_candidates < 1) throw InputError("max_candidates must be at least 1");
  for (const double value : {center_tolerance, pixel_tolerance_px}) {
    if (!std::isfinite(value) || value < 0.0) {
      throw InputError("center_tolerance and pixel_tolerance_px must be finite and not negative");
    }
  }
}

// An affine projection A maps the ring of radius R to an ellipse whose bounding box has half sides R |row i of A|. It
// maps the H, a rectangle of half sides a and b, to a shape whose bounding box has half sides a |A_i1| + b |A_i2|,
// which is between min(a, b) and hypot(a, b) times |row i of A|. Hence on each image axis the ratio of the boxes' sides
// is between min(a, b) / R and hypot(a, b) / R.
PadDetector::PadDetector(const models::LandingPad& pad, ComponentClassifier classify, const PadDetectorConfig& config)
    : classify_(std::move(classify)),
      config_(config),
      min_size_ratio_(std::min(pad.h_height_m, pad.h_width_m) / (2.0 * pad.outer_radius_m) / config.size_tolerance),
      max_size_ratio_(std::hypot(pad.h_height_m, pad.h_width_m) / (2.0 * pad.outer_radius_m) * config.size_tolerance) {
  pad.Validate();
  config.Validate();
}

bool PadDetector::IsPossiblePad(const Component& ring, const Component& letter) const {
  if (letter.u < ring.u || letter.u + letter.width > ring.u + ring.width || letter.v < ring.v ||
      letter.v + letter.height > ring.v + ring.height) {
    return false;
  }
  const Eigen::Vector2d ring_size(ring.width, ring.height), letter_size(letter.width, letter.height);
  const Eigen::Array2d slack = Eigen::Array2d::Constant(config_.pixel_tolerance_px);
  const bool size_fits = (letter_size.array() + slack >= min_size_ratio_ * ring_size.array()).all() &&
                         (letter_size.array() - slack <= max_size_ratio_ * ring_size.array()).all();
  const bool center_fits =
      (CenterOffset(ring, letter).array().abs() - slack <= config_.center_tolerance * ring_size.array()).all();
  return size_fits && center_fits;
}

PadDetector::Result PadDetector::Detect(const ComponentSet& components) const {
  Result result{Reason::kNoComponent, {}};
  if (components.components.empty()) return result;

  std::vector<Candidate> circles, letters;
  for (const Component& component : components.components) {
    const Classification classification = classify_(components, component);
    const double posterior = PosteriorOf(classification, classification.label);
    result.labeled.push_back(
        {{component.u, component.v, component.width, component.height}, classification.label, posterior});
    if (classification.label == ComponentClass::kCircle && !components.IsCutByBorder(component)) {
      circles.push_back({&component, posterior});
    }
    if (classification.label == ComponentClass::kH) {
      letters.push_back({&component, posterior});
    }
  }
  result.outcome = circles.empty() ? Reason::kNoCircle : Reason::kNoH;
  if (circles.empty() || letters.empty()) return result;

  result.outcome = Reason::kNoPair;
  std::vector<std::pair<std::pair<double, double>, DetectedPad>> pairs;
  for (const Candidate& ring : circles) {
    for (const Candidate& letter : letters) {
      if (ring.component == letter.component || !IsPossiblePad(*ring.component, *letter.component)) continue;
      pairs.push_back({{ring.posterior * letter.posterior, -CenterOffset(*ring.component, *letter.component).norm()},
                       {*ring.component, *letter.component}});
    }
  }
  if (pairs.empty()) return result;
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<DetectedPad> candidates;
  for (const auto& [score, pair] : pairs) {
    if (static_cast<int>(candidates.size()) < config_.max_candidates) candidates.push_back(pair);
  }
  result.outcome = std::move(candidates);
  return result;
}

}  // namespace touchdown::estimator::paper
