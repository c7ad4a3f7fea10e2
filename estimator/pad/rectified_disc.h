#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "estimator/pad/pad_plane.h"
#include "models/signals.h"

namespace touchdown::estimator::pad {

/// Values of the cells of a square, in row-major order.
using Cells = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The image of a disc around the origin of a plane, rectified onto that plane: kCells x kCells gray values over the
/// bounding square of the disc, with columns along the plane's first coordinate. Cells outside the disc are undefined.
class RectifiedDisc {
 public:
  static constexpr int kCells = 64;

  /// Rectifies a disc of radius `radius_m`; nullopt when part of it is outside the image.
  static std::optional<RectifiedDisc> Of(const models::ImageView& image, const PadPlane& plane, double radius_m);

  /// Center of a cell on the plane, m.
  Eigen::Vector2d CellCenter(int column, int row) const { return CellCenter(Eigen::Vector2d(column, row)); }
  /// Whether the center of a cell is within the disc.
  bool Contains(int column, int row) const { return CellCenter(column, row).norm() <= radius_m_; }
  /// Side of a cell, m.
  double cell_m() const { return 2.0 * radius_m_ / kCells; }
  const Cells& gray() const { return gray_; }

  /// Contrast-normalized cells: local mean minus cell, divided by the local standard deviation; dark cells are
  /// positive. The result does not depend on the brightness, is the same on both sides of a shadow's edge, and changes
  /// little in the haze of a glare. Standard deviations below `min_stddev`, of 255, are replaced by it.
  Cells ContrastNormalized(double min_stddev) const;

  /// Local mean around each cell, weighted with `weights`.
  static Cells LocalMean(const Cells& values, const Cells& weights);

 private:
  RectifiedDisc(double radius_m, Cells gray) : radius_m_(radius_m), gray_(std::move(gray)) {}
  Eigen::Vector2d CellCenter(const Eigen::Vector2d& cell) const {
    return radius_m_ * ((2.0 * cell.array() + 1.0) / kCells - 1.0).matrix();
  }

  double radius_m_;
  Cells gray_;
};

}  // namespace touchdown::estimator::pad
