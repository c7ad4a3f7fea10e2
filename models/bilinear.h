#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "models/signals.h"

namespace touchdown::models {

/// Gray value at a position in an image, px, interpolated bilinearly between the four pixels around it, whose centers
/// lie on integer coordinates. The position must be in [0, width - 1) x [0, height - 1).
template <typename Scalar>
Scalar BilinearGray(const ImageView& image, const Eigen::Vector2d& position) {
  const int u = static_cast<int>(position.x()), v = static_cast<int>(position.y());
  const auto a = static_cast<Scalar>(position.x() - u), b = static_cast<Scalar>(position.y() - v);
  const std::uint8_t* const upper = image.Row(v) + u;
  const std::uint8_t* const lower = image.Row(v + 1) + u;
  return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
}

/// Whether BilinearGray is defined at a position.
inline bool IsBetweenPixels(const ImageView& image, const Eigen::Vector2d& position) {
  return position.x() >= 0.0 && position.y() >= 0.0 && position.x() < image.width - 1 &&
         position.y() < image.height - 1;
}

}  // namespace touchdown::models
