#include "estimator/paper/pad_contours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace touchdown::estimator::paper {
namespace {

using Eigen::Vector2d;

enum class Part : std::uint8_t { kNone, kRing, kLetter };

/// For each pixel of the ring's box, whether it belongs to the component of the ring or of the letter.
class ComponentMap {
 public:
  ComponentMap(const ComponentSet& components, const DetectedPad& detected)
      : box_{detected.ring.u, detected.ring.v, detected.ring.width, detected.ring.height},
        parts_(static_cast<std::size_t>(box_.width) * static_cast<std::size_t>(box_.height), Part::kNone) {
    Mark(components, detected.ring, Part::kRing);
    Mark(components, detected.letter, Part::kLetter);
  }

  /// The part on the dark side of an edge pixel.
  Part OnDarkSide(const Vector2d& pixel, const Vector2d& to_bright) const {
    for (const double step : {0.0, 1.0, 2.0}) {
      const Vector2d p = pixel - step * to_bright;
      const Part part = At(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())));
      if (part != Part::kNone) return part;
    }
    return Part::kNone;
  }

 private:
  void Mark(const ComponentSet& components, const Component& component, Part part) {
    for (const Run& run : components.RunsOf(component)) {
      auto* row = parts_.data() + static_cast<std::ptrdiff_t>(run.v - box_.v) * box_.width;
      std::fill(row + (run.u_begin - box_.u), row + (run.u_end - box_.u), part);
    }
  }
  Part At(int u, int v) const {
    const int x = u - box_.u, y = v - box_.v;
    if (x < 0 || y < 0 || x >= box_.width || y >= box_.height) return Part::kNone;
    return parts_[static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width) + static_cast<std::size_t>(x)];
  }

  PixelBox box_;
  std::vector<Part> parts_;
};

}  // namespace

pad::PadContours FindContours(const models::ImageView& image, const ComponentSet& components,
                              const DetectedPad& detected, const models::LandingPad& pad,
                              const pad::EdgeConfig& config) {
  const Component& ring = detected.ring;
  const ComponentMap parts(components, detected);
  const Vector2d center(ring.u + 0.5 * (ring.width - 1), ring.v + 0.5 * (ring.height - 1));
  const pad::ContourClassifier classify = [&](const Vector2d& pixel, const Vector2d& to_bright) {
    const Part part = parts.OnDarkSide(pixel, to_bright);
    if (part == Part::kNone) return pad::Contour::kNone;
    if (part == Part::kLetter) return pad::Contour::kLetter;
    return to_bright.dot(pixel - center) > 0.0 ? pad::Contour::kRingOuter : pad::Contour::kRingInner;
  };
  return pad::FindContours(image, {ring.u, ring.v, ring.width, ring.height}, classify, pad, config);
}

}  // namespace touchdown::estimator::paper
