#include "estimator/paper/rectified_disc.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace touchdown::estimator {
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

/// The image around `places`, so smooth that a cell sees all of its own area; subtracts the part's origin from them.
cv::Mat1f SmoothPart(const models::ImageView& image, cv::Mat2f& places) {
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
  if (part.empty()) return {};
  const cv::Mat grey(part.height, part.width, CV_8UC1, const_cast<std::uint8_t*>(image.Row(part.y) + part.x),
                     static_cast<std::size_t>(image.stride));
  cv::Mat1f smooth;
  grey.convertTo(smooth, CV_32F);
  if (px_per_cell > 1.2) cv::GaussianBlur(smooth, smooth, {}, 0.4 * px_per_cell);
  places -= cv::Scalar(part.x, part.y);
  return smooth;
}

}  // namespace

std::optional<RectifiedDisc> RectifiedDisc::Of(const models::ImageView& image, const SeenPlane& plane,
                                               double radius_m) {
  RectifiedDisc disc(radius_m, Cells(kCells, kCells));
  cv::Mat2f places(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const auto pixel = plane.PixelAt(disc.PointOf(column, row));
      if (!pixel) return std::nullopt;
      places(row, column) = {static_cast<float>(pixel->x()), static_cast<float>(pixel->y())};
    }
  }
  const cv::Mat1f part = SmoothPart(image, places);
  if (part.empty()) return std::nullopt;
  cv::Mat1f grey = View(disc.grey_);
  cv::remap(part, grey, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return disc;
}

Cells RectifiedDisc::LocalMean(const Cells& values, const Cells& weights) {
  constexpr float kNothing = 1e-6F;
  return WindowMean(values * weights) / (WindowMean(weights) + kNothing);
}

Cells RectifiedDisc::Levelled(double noise) const {
  const Cells everywhere = Cells::Ones(kCells, kCells);
  const Cells mean = LocalMean(grey_, everywhere);
  const Cells variance = LocalMean(grey_.square(), everywhere) - mean.square();
  return (mean - grey_) / variance.max(static_cast<float>(noise * noise)).sqrt();
}

}  // namespace touchdown::estimator
