#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "estimator/pad/pad_plane.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// Values of a square's cells, row by row.
using Cells = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What a camera sees of a disc about the origin of a plane, laid back on that plane: kCells x kCells gray values over
/// the square around it, columns along the plane's first coordinate. Cells outside the disc mean nothing.
class RectifiedDisc {
 public:
  static constexpr int kCells = 64;

  /// nullopt where part of the disc is not seen.
  static std::optional<RectifiedDisc> Of(const models::ImageView& image, const PadPlane& plane, double radius_m);

  /// Of the cell's middle, on the plane, m.
  Eigen::Vector2d PointOf(int column, int row) const { return PointOf(Eigen::Vector2d(column, row)); }
  bool Holds(int column, int row) const { return PointOf(column, row).norm() <= radius_m_; }
  double cell_m() const { return 2.0 * radius_m_ / kCells; }
  const Cells& gray() const { return gray_; }

  /// How much darker each cell is than those around it, over their standard deviation: the same under bright and dim
  /// light, on both sides of a shadow's edge, and nearly so in the haze of a glare. A deviation below `noise`, of 255,
  /// counts as this one.
  Cells ContrastNormalized(double noise) const;

  /// The mean of the cells around each, weighed with `weights`.
  static Cells LocalMean(const Cells& values, const Cells& weights);

 private:
  RectifiedDisc(double radius_m, Cells gray) : radius_m_(radius_m), gray_(std::move(gray)) {}
  Eigen::Vector2d PointOf(const Eigen::Vector2d& cell) const {
    return radius_m_ * ((2.0 * cell.array() + 1.0) / kCells - 1.0).matrix();
  }

  double radius_m_;
  Cells gray_;
};

}  // namespace touchdown::estimator::pad
