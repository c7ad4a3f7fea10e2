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

/// The window over which light is taken to be even: about as wide as an H in its ring.
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

/// The part of the image that holds `places`, so smooth that a cell sees all of its own area.
struct SmoothPart {
  cv::Mat1f gray;
  cv::Point origin;
};

SmoothPart PartAround(const models::ImageView& image, const cv::Mat2f& places) {
  std::vector<cv::Mat1f> coordinates;
  cv::split(places, coordinates);
  double least_u, most_u, least_v, most_v;
  cv::minMaxLoc(coordinates[0], &least_u, &most_u);
  cv::minMaxLoc(coordinates[1], &least_v, &most_v);
  const double px_per_cell = std::max(most_u - least_u, most_v - least_v) / RectifiedDisc::kCells;
  const double margin = 2.0 + px_per_cell;
  const cv::Rect whole(0, 0, image.width, image.height);
  const cv::Rect part = whole & cv::Rect(cv::Point(cvFloor(least_u - margin), cvFloor(least_v - margin)),
                                         cv::Point(cvCeil(most_u + margin), cvCeil(most_v + margin)));
  const cv::Mat gray(part.height, part.width, CV_8UC1, const_cast<std::uint8_t*>(image.Row(part.y) + part.x),
                     static_cast<std::size_t>(image.stride));
  SmoothPart smooth{{}, part.tl()};
  gray.convertTo(smooth.gray, CV_32F);
  if (px_per_cell > 1.2) cv::GaussianBlur(smooth.gray, smooth.gray, {}, 0.4 * px_per_cell);
  return smooth;
}

/// The pixels that see the points of a square grid over a disc, between whose nodes the lens and the perspective change
/// little.
class PixelGrid {
 public:
  /// `node_at` tells the pixel of a point, given in cells; nodes far from the disc are never asked for.
  template <typename NodeAt>
  static std::optional<PixelGrid> Of(const NodeAt& node_at) {
    constexpr double kReach = 0.5 * RectifiedDisc::kCells * 1.2;  // Of the nodes around cells of the disc.
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
  const auto grid = PixelGrid::Of([&](const Vector2d& cell) { return plane.PixelAt(disc.PointOf(cell)); });
  const auto center = plane.PixelAt(Vector2d::Zero());
  if (!grid || !center) return std::nullopt;
  cv::Mat2f places(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const bool inside = disc.Holds(column, row);
      const Vector2d pixel = inside ? grid->At(column, row) : *center;
      if (!(pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1 && pixel.y() <= image.height - 1)) {
        return std::nullopt;
      }
      places(row, column) = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
    }
  }
  const SmoothPart part = PartAround(image, places);
  places -= cv::Scalar(part.origin.x, part.origin.y);
  cv::Mat1f gray = View(disc.gray_);
  cv::remap(part.gray, gray, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return disc;
}

Cells RectifiedDisc::LocalMean(const Cells& values, const Cells& weights) {
  constexpr float kNothing = 1e-6F;
  return WindowMean(values * weights) / (WindowMean(weights) + kNothing);
}

Cells RectifiedDisc::ContrastNormalized(double noise) const {
  Cells inside(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) inside(row, column) = Holds(column, row) ? 1.0F : 0.0F;
  }
  const Cells mean = LocalMean(gray_, inside);
  const Cells variance = LocalMean(gray_.square(), inside) - mean.square();
  return (mean - gray_) / variance.max(static_cast<float>(noise * noise)).sqrt();
}

}  // namespace touchdown::estimator::pad
