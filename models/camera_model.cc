#include "models/camera_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "models/error.h"

namespace touchdown::models {
namespace {

/// Smallest positive root of 1 + a s + b s^2 + c s^3, with c != 0; infinity if there is none. The roots are the real
/// eigenvalues of the companion matrix.
double SmallestPositiveRoot(double a, double b, double c) {
  Eigen::Matrix3d companion;
  companion << 0.0, 0.0, -1.0 / c, 1.0, 0.0, -a / c, 0.0, 1.0, -b / c;
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& root : companion.eigenvalues()) {
    constexpr double kRoundOff = 1e-7;  // Round-off splits a double root into a complex pair.
    const bool is_real = std::abs(root.imag()) <= kRoundOff * std::abs(root);
    if (is_real && root.real() > 0.0) smallest = std::min(smallest, root.real());
  }
  return smallest;
}

void RequireUndistortable(const CameraModel& camera) {
  for (const double u : {-0.5, camera.width_px - 0.5}) {
    for (const double v : {-0.5, camera.height_px - 0.5}) {
      if (!camera.Ray({u, v})) throw InputError("the camera's distortion is not invertible within the image");
    }
  }
}

}  // namespace

void Describe(ConfigVisitor& v, CameraModel& c) {
  v.Integer({"width_px", "Width of the image."}, c.width_px, kImageSize_px);
  v.Integer({"height_px", "Height of the image."}, c.height_px, kImageSize_px);
  v.Number({"fx_px", "Horizontal focal length. A larger value narrows the field of view."}, c.fx_px, kPixel, kPositive);
  v.Number({"fy_px", "Vertical focal length; equal to fx_px for square pixels."}, c.fy_px, kPixel, kPositive);
  v.Number({"cx_px", "Horizontal coordinate of the principal point. Pixel centers lie on integers."}, c.cx_px, kPixel,
           kAny);
  v.Number({"cy_px", "Vertical coordinate of the principal point."}, c.cy_px, kPixel, kAny);
  v.Number({"k1", "First radial distortion coefficient (plumb_bob). Negative values give barrel distortion."}, c.k1,
           kNoUnit, kAny);
  v.Number({"k2", "Second radial distortion coefficient."}, c.k2, kNoUnit, kAny);
  v.Number({"p1", "First tangential distortion coefficient."}, c.p1, kNoUnit, kAny);
  v.Number({"p2", "Second tangential distortion coefficient."}, c.p2, kNoUnit, kAny);
  v.Number({"k3", "Third radial distortion coefficient."}, c.k3, kNoUnit, kAny);
  v.Check("", [&c] { RequireUndistortable(c); });
}

void CameraModel::Validate() const { ValidateConfig(*this); }

Eigen::Vector2d CameraModel::Distort(const Eigen::Vector2d& ideal) const {
  const double r2 = ideal.squaredNorm();
  const Eigen::Vector2d radial = ideal * (1.0 + r2 * (k1 + r2 * (k2 + r2 * k3)));
  if (!HasTangentialTerms()) return radial;
  const double x = ideal.x(), y = ideal.y();
  return radial +
         Eigen::Vector2d(2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x), p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
}

Eigen::Matrix2d CameraModel::DistortJacobian(const Eigen::Vector2d& ideal) const {
  const double x = ideal.x(), y = ideal.y(), r2 = ideal.squaredNorm();
  const double gain = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // Derivative of the gain with respect to r^2 / 2.
  Eigen::Matrix2d jacobian = gain * Eigen::Matrix2d::Identity() + slope * ideal * ideal.transpose();
  const double shear = 2.0 * (p1 * x + p2 * y);
  jacobian += Eigen::Matrix2d{{2.0 * p1 * y + 6.0 * p2 * x, shear}, {shear, 6.0 * p1 * y + 2.0 * p2 * x}};
  return jacobian;
}

double CameraModel::MonotonicRadius() const {
  // The derivative of r (1 + k1 r^2 + k2 r^4 + k3 r^6) is 1 + 3 k1 s + 5 k2 s^2 + 7 k3 s^3 with s = r^2. Without k3 its
  // smallest positive root is 2 / q, a form that avoids cancellation and also holds for k2 = 0.
  if (k3 != 0.0) return std::sqrt(SmallestPositiveRoot(3.0 * k1, 5.0 * k2, 7.0 * k3));
  const double discriminant = 9.0 * k1 * k1 - 20.0 * k2;
  const double q = discriminant >= 0.0 ? -3.0 * k1 + std::sqrt(discriminant) : 0.0;
  return q > 0.0 ? std::sqrt(2.0 / q) : std::numeric_limits<double>::infinity();
}

std::optional<Eigen::Vector2d> CameraModel::Undistort(const Eigen::Vector2d& distorted) const {
  const auto radial = UndistortRadial(distorted);
  if (!radial || !HasTangentialTerms()) return radial;
  Eigen::Vector2d ideal = *radial;
  constexpr int kMaxIterations = 30;
  constexpr double kTolerance = 1e-13;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Matrix2d jacobian = DistortJacobian(ideal);
    if (!(jacobian.determinant() > 0.0)) return std::nullopt;
    const Eigen::Vector2d step = jacobian.inverse() * (distorted - Distort(ideal));
    ideal += step;
    if (step.norm() <= kTolerance * (1.0 + ideal.norm())) return ideal;
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> CameraModel::UndistortRadial(const Eigen::Vector2d& distorted) const {
  const double r_distorted = distorted.norm();
  if (r_distorted == 0.0) return distorted;
  const double r_max = MonotonicRadius();
  const auto gain = [this](double r2) { return 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3)); };
  if (std::isfinite(r_max) && r_max * gain(r_max * r_max) <= r_distorted) return std::nullopt;

  // Newton's method on the radius, kept within the bracket in which the distortion is monotonic.
  double low = 0.0, high = r_max;
  double r = std::min(r_distorted, r_max);
  constexpr int kMaxIterations = 100;
  constexpr double kTolerance = 1e-14;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double r2 = r * r;
    const double error = r * gain(r2) - r_distorted;
    (error > 0.0 ? high : low) = r;
    double next = r - error / (1.0 + r2 * (3.0 * k1 + r2 * (5.0 * k2 + r2 * 7.0 * k3)));
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
