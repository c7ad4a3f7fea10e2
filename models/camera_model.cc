#include "models/camera_model.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/error.h"

namespace touchdown::models {
namespace {

constexpr int kLargestImage_px = 16384;

}  // namespace

void CameraModel::Validate() const {
  if (width_px <= 0 || height_px <= 0 || width_px > kLargestImage_px || height_px > kLargestImage_px) {
    throw InputError("the camera's image must be 1 to 16384 px wide and high");
  }
  for (const double value : {fx_px, fy_px, cx_px, cy_px, k1, k2}) {
    if (!std::isfinite(value)) throw InputError("the camera has a number that is not finite");
  }
  if (fx_px <= 0.0 || fy_px <= 0.0) throw InputError("the camera's focal lengths must be positive");
  for (const double u : {-0.5, width_px - 0.5}) {
    for (const double v : {-0.5, height_px - 0.5}) {
      if (!Ray({u, v})) throw InputError("the camera's distortion (k1, k2) folds within the image");
    }
  }
}

Eigen::Vector2d CameraModel::Distort(const Eigen::Vector2d& ideal) const {
  const double r2 = ideal.squaredNorm();
  return ideal * (1.0 + r2 * (k1 + r2 * k2));
}

double CameraModel::MonotonicRadius() const {
  // The derivative of r (1 + k1 r^2 + k2 r^4) is 1 + 3 k1 s + 5 k2 s^2 with s = r^2. Its smallest positive root is
  // 2 / q, in the form that does not cancel and holds for k2 = 0 as well.
  const double discriminant = 9.0 * k1 * k1 - 20.0 * k2;
  const double q = discriminant >= 0.0 ? -3.0 * k1 + std::sqrt(discriminant) : 0.0;
  return q > 0.0 ? std::sqrt(2.0 / q) : std::numeric_limits<double>::infinity();
}

std::optional<Eigen::Vector2d> CameraModel::Undistort(const Eigen::Vector2d& distorted) const {
  const double r_distorted = distorted.norm();
  if (r_distorted == 0.0) return distorted;
  const double r_max = MonotonicRadius();
  if (std::isfinite(r_max) && Distort({r_max, 0.0}).x() <= r_distorted) return std::nullopt;

  // Newton on the radius, kept inside the bracket within which the distortion grows.
  double low = 0.0, high = r_max;
  double r = std::min(r_distorted, r_max);
  constexpr int kMaxIterations = 100;
  constexpr double kTolerance = 1e-14;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double r2 = r * r;
    const double error = r * (1.0 + r2 * (k1 + r2 * k2)) - r_distorted;
    (error > 0.0 ? high : low) = r;
    double next = r - error / (1.0 + r2 * (3.0 * k1 + r2 * 5.0 * k2));
    if (!(next > low && next < high)) next = std::isfinite(high) ? 0.5 * (low + high) : 2.0 * r;
    const double step = std::abs(next - r);
    r = next;
    if (step <= kTolerance * r) break;
  }
  return distorted * (r / r_distorted);
}

Eigen::Vector2d CameraModel::PixelFromNormalized(const Eigen::Vector2d& distorted) const {
  return {fx_px * distorted.x() + cx_px, fy_px * distorted.y() + cy_px};
}

Eigen::Vector2d CameraModel::NormalizedFromPixel(const Eigen::Vector2d& pixel) const {
  return {(pixel.x() - cx_px) / fx_px, (pixel.y() - cy_px) / fy_px};
}

std::optional<Eigen::Vector2d> CameraModel::Project(const Eigen::Vector3d& p_C) const {
  if (p_C.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d ideal = p_C.hnormalized();
  if (ideal.norm() >= MonotonicRadius()) return std::nullopt;
  return PixelFromNormalized(Distort(ideal));
}

std::optional<Eigen::Vector3d> CameraModel::Ray(const Eigen::Vector2d& pixel) const {
  const auto ideal = Undistort(NormalizedFromPixel(pixel));
  if (!ideal) return std::nullopt;
  return ideal->homogeneous().normalized();
}

bool CameraModel::Contains(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.x() <= width_px - 0.5 && pixel.y() >= -0.5 && pixel.y() <= height_px - 0.5;
}

}  // namespace touchdown::models
