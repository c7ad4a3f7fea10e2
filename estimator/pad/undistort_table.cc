#include "estimator/pad/undistort_table.h"

#include <algorithm>
#include <cmath>

#include "models/error.h"

namespace touchdown::estimator::pad {

UndistortTable::UndistortTable(const models::CameraModel& camera) : width_(camera.width_px), height_(camera.height_px) {
  entries_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const Eigen::Vector2d raw(u, v);
      const auto ideal = camera.Undistort(camera.NormalizedFromPixel(raw));
      if (!ideal) throw InputError("the camera's distortion is not invertible within the image");
      entries_.emplace_back((camera.PixelFromNormalized(*ideal) - raw).cast<float>());
    }
  }
}

const Eigen::Vector2f& UndistortTable::Entry(int u, int v) const {
  return entries_[static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u)];
}

Eigen::Vector2d UndistortTable::At(const Eigen::Vector2d& pixel) const {
  const int u = std::clamp(static_cast<int>(std::floor(pixel.x())), 0, std::max(0, width_ - 2));
  const int v = std::clamp(static_cast<int>(std::floor(pixel.y())), 0, std::max(0, height_ - 2));
  const int u1 = std::min(u + 1, width_ - 1), v1 = std::min(v + 1, height_ - 1);
  const double x = pixel.x() - u, y = pixel.y() - v;
  const Eigen::Vector2d upper = (1.0 - x) * Entry(u, v).cast<double>() + x * Entry(u1, v).cast<double>();
  const Eigen::Vector2d lower = (1.0 - x) * Entry(u, v1).cast<double>() + x * Entry(u1, v1).cast<double>();
  return pixel + (1.0 - y) * upper + y * lower;
}

}  // namespace touchdown::estimator::pad
