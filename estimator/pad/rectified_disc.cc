#include "estimator/pad/rectified_disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

/// Width, in cells, of the window over which the illumination is assumed to be uniform: about the width of the H.
constexpr int kWindow = RectifiedDisc::kCells * 3 / 8;

cv::Mat1f View(const Cells& cells) {
  return {static_cast<int>(cells.rows()), static_cast<int>(cells.cols()), const_cast<float*>(cells.data())};
}

Cells WindowMean(const Cells& values) {
  Cells mean(values.rows(), values.cols());
  cv::Mat1f once, twice = View(mean);
  cv::boxFilter(View(values), once, CV_32F, {kWindow | 1, kWindow | 1}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(once, twice, CV_32F, {kWindow | 1, kWindow | 1}, {-1, -1}, true, cv::BORDER_CONSTANT);
  return mean;
}

/// The part of an image that a grid of pixels covers, smoothed so that a cell averages its whole area.
struct SmoothedPart {
  cv::Mat1f gray;
  cv::Point origin;
};

SmoothedPart PartAround(const models::ImageView& image, const cv::Mat2f& pixels) {
  std::vector<cv::Mat1f> coordinates;
  cv::split(pixels, coordinates);
  double min_u, max_u, min_v, max_v;
  cv::minMaxLoc(coordinates[0], &min_u, &max_u);
  cv::minMaxLoc(coordinates[1], &min_v, &max_v);
  const double px_per_cell = std::max(max_u - min_u, max_v - min_v) / RectifiedDisc::kCells;
  const double margin = 2.0 + px_per_cell;
  const cv::Rect whole(0, 0, image.width, image.height);
  const cv::Rect part = whole & cv::Rect(cv::Point(cvFloor(min_u - margin), cvFloor(min_v - margin)),
                                         cv::Point(cvCeil(max_u + margin), cvCeil(max_v + margin)));
  const cv::Mat gray(part.height, part.width, CV_8UC1, const_cast<std::uint8_t*>(image.Row(part.y) + part.x),
                     static_cast<std::size_t>(image.stride));
  SmoothedPart smooth{{}, part.tl()};
  gray.convertTo(smooth.gray, CV_32F);
  if (px_per_cell > 1.2) cv::GaussianBlur(smooth.gray, smooth.gray, {}, 0.4 * px_per_cell);
  return smooth;
}

/// Pixels of the cells of a disc, interpolated between the nodes of a square grid. Between neighboring nodes the change
/// of lens distortion and perspective is small.
class PixelGrid {
 public:
  /// `node_at` returns the pixel of a point given in cells. It is not called for nodes far from the disc.
  template <typename NodeAt>
  static std::optional<PixelGrid> Of(const NodeAt& node_at) {
    constexpr double kReach =
        0.5 * RectifiedDisc::kCells * 1.2;  // Largest distance, in cells, of a node from the center.
    PixelGrid grid;
    for (int row = 0; row < kNodes; ++row) {
      for (int column = 0; column < kNodes; ++column) {
        const Vector2d cell(column * kStep, row * kStep);
        if ((cell - Vector2d::Constant(0.5 * (RectifiedDisc::kCells - 1))).norm() > kReach) continue;
        const auto pixel = node_at(cell);
        if (!pixel) return std::nullopt;
        grid.nodes_[row][column] = *pixel;
      }
    }
    return grid;
  }

  Vector2d At(int column, int row) const {
    const int i = column / kStep, j = row / kStep;
    const double a = static_cast<double>(column % kStep) / kStep, b = static_cast<double>(row % kStep) / kStep;
    return (1 - b) * ((1 - a) * nodes_[j][i] + a * nodes_[j][i + 1]) +
           b * ((1 - a) * nodes_[j + 1][i] + a * nodes_[j + 1][i + 1]);
  }

 private:
  static constexpr int kStep = 4, kNodes = RectifiedDisc::kCells / kStep + 1;
  std::array<std::array<Vector2d, kNodes>, kNodes> nodes_;
};

}  // namespace

std::optional<RectifiedDisc> RectifiedDisc::Of(const models::ImageView& image, const PadPlane& plane, double radius_m) {
  RectifiedDisc disc(radius_m, Cells(kCells, kCells));
  const auto grid = PixelGrid::Of([&](const Vector2d& cell) { return plane.PixelAt(disc.CellCenter(cell)); });
  const auto center = plane.PixelAt(Vector2d::Zero());
  if (!grid || !center) return std::nullopt;
  cv::Mat2f pixels(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const bool inside = disc.Contains(column, row);
      const Vector2d pixel = inside ? grid->At(column, row) : *center;
      if (!(pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1 && pixel.y() <= image.height - 1)) {
        return std::nullopt;
      }
      pixels(row, column) = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
    }
  }
  const SmoothedPart part = PartAround(image, pixels);
  pixels -= cv::Scalar(part.origin.x, part.origin.y);
  cv::Mat1f gray = View(disc.gray_);
  cv::remap(part.gray, gray, pixels, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return disc;
}

Cells RectifiedDisc::LocalMean(const Cells& values, const Cells& weights) {
  constexpr float kTiny = 1e-6F;  // Avoids a division by 0.
  return WindowMean(values * weights) / (WindowMean(weights) + kTiny);
}

Cells RectifiedDisc::ContrastNormalized(double min_stddev) const {
  Cells inside(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) inside(row, column) = Contains(column, row) ? 1.0F : 0.0F;
  }
  const Cells mean = LocalMean(gray_, inside);
  const Cells variance = LocalMean(gray_.square(), inside) - mean.square();
  return (mean - gray_) / variance.max(static_cast<float>(min_stddev * min_stddev)).sqrt();
}

}  // namespace touchdown::estimator::pad
