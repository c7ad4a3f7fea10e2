#include "estimator/pad/letter_outline.h"

#include <algorithm>
#include <array>

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

/// The quarter of the H's outline where x and y are positive: the H is symmetric about both axes of W.
struct QuarterOutline {
  explicit QuarterOutline(const models::LandingPad& pad) {
    const double x = 0.5 * pad.h_height_m, y = 0.5 * pad.h_width_m;
    const double bar_x = 0.5 * pad.h_stroke_m, inner_y = y - pad.h_stroke_m;
    if (pad.letter() == models::PadLetter::kRectangle) {
      corners = {Vector2d(0.0, y), Vector2d(x, y), Vector2d(x, 0.0)};
      sides = 2;
    } else {
      corners = {Vector2d(0.0, y), Vector2d(x, y), Vector2d(x, inner_y), Vector2d(bar_x, inner_y),
                 Vector2d(bar_x, 0.0)};
      sides = 4;
    }
  }

  std::array<Vector2d, 5> corners;  // From one axis to the other; the first `sides` + 1.
  std::size_t sides;
};

double DistanceFromSegment(const Vector2d& from, const Vector2d& to, const Vector2d& point) {
  const Vector2d along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from + share * along - point).norm();
}

}  // namespace

std::vector<Vector2d> LetterOutline(const models::LandingPad& pad, double spacing_m) {
  const QuarterOutline quarter(pad);
  std::vector<Vector2d> outline;
  for (const Vector2d& mirror : {Vector2d(1, 1), Vector2d(1, -1), Vector2d(-1, -1), Vector2d(-1, 1)}) {
    for (std::size_t i = 0; i < quarter.sides; ++i) {
      const Vector2d from = quarter.corners[i], side = quarter.corners[i + 1] - from;
      const int count = std::max(2, static_cast<int>(side.norm() / spacing_m));
      for (int k = 0; k < count; ++k) {
        outline.push_back((from + side * ((k + 0.5) / count)).cwiseProduct(mirror));
      }
    }
  }
  return outline;
}

double DistanceFromLetter(const models::LandingPad& pad, const Vector2d& p_W) {
  const QuarterOutline quarter(pad);
  const auto& corners = quarter.corners;
  const Vector2d p = p_W.cwiseAbs();
  double distance = DistanceFromSegment(corners[0], corners[1], p);
  for (std::size_t i = 1; i < quarter.sides; ++i) {
    distance = std::min(distance, DistanceFromSegment(corners[i], corners[i + 1], p));
  }
  return distance;
}

}  // namespace touchdown::estimator::pad
