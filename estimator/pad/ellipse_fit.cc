#include "estimator/pad/ellipse_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "models/angles.h"
#include "models/error.h"
#include "models/order_statistic.h"

namespace touchdown::estimator::pad {
namespace {

constexpr std::size_t kMinPoints = 6;

/// Coefficients (a, b, c, d, e, f) of a x^2 + b x y + c y^2 + d x + e y + f = 0 with 4ac - b^2 > 0 that minimize the
/// algebraic distance, in the notation of Halir and Flusser. nullopt when the points do not determine an ellipse.
std::optional<Eigen::Matrix<double, 6, 1>> DirectFit(const Eigen::Matrix2Xd& points) {
  Eigen::Matrix3d S1 = Eigen::Matrix3d::Zero(), S2 = S1, S3 = S1;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double x = points(0, i), y = points(1, i);
    const Eigen::Vector3d quadratic(x * x, x * y, y * y), linear(x, y, 1.0);
    S1 += quadratic * quadratic.transpose();
    S2 += quadratic * linear.transpose();
    S3 += linear * linear.transpose();
  }
  const Eigen::LDLT<Eigen::Matrix3d> S3_factors(S3);
  constexpr double kSingular = 1e-10;
  if (S3_factors.vectorD().minCoeff() < kSingular * S3_factors.vectorD().maxCoeff()) return std::nullopt;
  const Eigen::Matrix3d T = -S3_factors.solve(S2.transpose());
  const Eigen::Matrix3d M0 = S1 + S2 * T;
  Eigen::Matrix3d M;  // C1^-1 (S1 + S2 T)
  M << 0.5 * M0.row(2), -M0.row(1), 0.5 * M0.row(0);

  const Eigen::EigenSolver<Eigen::Matrix3d> eigen(M);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  std::optional<Eigen::Matrix<double, 6, 1>> best;
  double best_constraint = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a1 = eigen.eigenvectors().col(i).real();
    const double constraint = (4.0 * a1(0) * a1(2) - a1(1) * a1(1)) / a1.squaredNorm();
    if (!(constraint > best_constraint)) continue;
    best_constraint = constraint;
    best.emplace();
    *best << a1, T * a1;
  }
  return best;
}

/// Distance beyond which a point is an outlier, in medians of the distances: 2.5 sigma of a normal error.
constexpr double kOutlierMedians = 3.7;

double MedianDistance(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points) {
  std::vector<double> distances;
  for (const Eigen::Vector2d& point : points) distances.push_back(std::abs(DistanceFrom(ellipse, point)));
  return models::UpperMedian(distances);
}

/// Gaps between the points along an ellipse, as intervals of its parameter angle.
class Gaps {
 public:
  Gaps(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points) : ellipse_(ellipse) {
    std::vector<double> angles;
    for (const Eigen::Vector2d& point : points) angles.push_back(AngleOf(point));
    std::sort(angles.begin(), angles.end());
    // On a small ring neighboring pixels are far apart in angle.
    constexpr double kMinGap = 0.2, kMinGap_px = 3.0;
    const double min_gap = std::max(kMinGap, kMinGap_px / ellipse.semi_axes.mean());
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const bool is_last = i + 1 == angles.size();
      const double next = is_last ? angles.front() + 2.0 * models::kPi : angles[i + 1];
      if (next - angles[i] > min_gap) gaps_.push_back({angles[i], next});
    }
  }

  double Coverage() const {
    double missing = 0.0;
    for (const auto& [begin, end] : gaps_) missing += end - begin;
    return 1.0 - missing / (2.0 * models::kPi);
  }

  bool IsBeside(const Eigen::Vector2d& point) const {
    constexpr double kNear = 0.17;
    const double angle = AngleOf(point);
    return std::any_of(gaps_.begin(), gaps_.end(), [&](const auto& gap) {
      return std::abs(models::WrapToPi(angle - gap.first)) < kNear ||
             std::abs(models::WrapToPi(angle - gap.second)) < kNear;
    });
  }

 private:
  double AngleOf(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d p =
        (Eigen::Rotation2Dd(-ellipse_.angle) * (point - ellipse_.center)).cwiseQuotient(ellipse_.semi_axes);
    return std::atan2(p.y(), p.x());
  }

  const Ellipse& ellipse_;
  std::vector<std::pair<double, double>> gaps_;  // Begin and end, rad.
};

}  // namespace

Eigen::Matrix2d Ellipse::Shape() const {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return R * semi_axes.cwiseAbs2().asDiagonal() * R.transpose();
}

Eigen::Matrix3d Ellipse::Conic() const {
  const Eigen::Matrix2d W = Shape().inverse();
  Eigen::Matrix3d conic;
  conic.topLeftCorner<2, 2>() = W;
  conic.topRightCorner<2, 1>() = -W * center;
  conic.bottomLeftCorner<1, 2>() = -(W * center).transpose();
  conic(2, 2) = center.dot(W * center) - 1.0;
  return conic;
}

std::optional<Ellipse> Ellipse::FromShape(const Eigen::Vector2d& center, const Eigen::Matrix2d& shape) {
  if (!center.allFinite() || !shape.allFinite()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(shape);
  if (!(eigen.eigenvalues()(0) > 0.0)) return std::nullopt;
  const Eigen::Vector2d major = eigen.eigenvectors().col(1);
  return Ellipse{.center = center,
                 .semi_axes = eigen.eigenvalues().reverse().cwiseSqrt(),
                 .angle = models::WrapToHalfPi(std::atan2(major.y(), major.x()))};
}

std::optional<Ellipse> Ellipse::FromConic(const Eigen::Matrix3d& conic) {
  if (!conic.allFinite()) return std::nullopt;
  Eigen::Matrix2d A = conic.topLeftCorner<2, 2>();
  if (A.determinant() <= 0.0) return std::nullopt;
  const double sign = A.trace() > 0.0 ? 1.0 : -1.0;
  A *= sign;
  const Eigen::Vector2d center = -A.inverse() * (sign * conic.topRightCorner<2, 1>());
  const double level = center.dot(A * center) - sign * conic(2, 2);
  if (!(level > 0.0)) return std::nullopt;
  return FromShape(center, level * A.inverse());
}

std::optional<Ellipse> FitEllipse(std::span<const Eigen::Vector2d> points) {
  if (points.size() < kMinPoints) return std::nullopt;
  Eigen::Matrix2Xd moved(2, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < moved.cols(); ++i) moved.col(i) = points[static_cast<std::size_t>(i)];
  if (!moved.allFinite()) return std::nullopt;
  const Eigen::Vector2d centroid = moved.rowwise().mean();
  moved.colwise() -= centroid;
  const double scale = std::sqrt(moved.squaredNorm() / static_cast<double>(moved.cols()));
  if (scale == 0.0) return std::nullopt;
  moved /= scale;

  const auto fit = DirectFit(moved);
  if (!fit) return std::nullopt;
  const Eigen::Matrix<double, 6, 1>& a = *fit;
  Eigen::Matrix3d conic;
  conic << a(0), a(1) / 2.0, a(3) / 2.0, a(1) / 2.0, a(2), a(4) / 2.0, a(3) / 2.0, a(4) / 2.0, a(5);
  auto ellipse = Ellipse::FromConic(conic);
  if (!ellipse) return std::nullopt;
  ellipse->center = centroid + scale * ellipse->center;
  ellipse->semi_axes *= scale;
  return ellipse;
}

double DistanceFrom(const Ellipse& ellipse, const Eigen::Vector2d& point) {
  const Eigen::Vector2d from_center = point - ellipse.center;
  const Eigen::Vector2d half_gradient = ellipse.Shape().inverse() * from_center;
  const double gradient = 2.0 * half_gradient.norm();
  if (gradient == 0.0) return -ellipse.semi_axes.y();
  return (from_center.dot(half_gradient) - 1.0) / gradient;
}

double RmsDistance(const Ellipse& ellipse, std::span<const Eigen::Vector2d> points) {
  double sum = 0.0;
  for (const Eigen::Vector2d& point : points) {
    const double distance = DistanceFrom(ellipse, point);
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

void RingFitConfig::Validate() const {
  for (const double value : {tolerance_px, max_relative_rms, min_coverage}) {
    if (!std::isfinite(value) || value <= 0.0)
      throw InputError("the limits of the ring fit must be positive and finite");
  }
  if (min_coverage > 1.0) throw InputError("min_coverage must be at most 1");
}

std::optional<Ellipse> FitRing(std::vector<Eigen::Vector2d>& points, const RingFitConfig& config) {
  auto ellipse = FitEllipse(points);
  constexpr int kIterations = 5;
  for (int i = 0; i < kIterations && ellipse; ++i) {
    const double limit = std::max(config.tolerance_px, kOutlierMedians * MedianDistance(*ellipse, points));
    std::vector<Eigen::Vector2d> near;
    for (const Eigen::Vector2d& point : points) {
      if (std::abs(DistanceFrom(*ellipse, point)) <= limit) near.push_back(point);
    }
    if (near.size() == points.size()) break;
    points = std::move(near);
    ellipse = FitEllipse(points);
  }
  if (!ellipse) return std::nullopt;
  const Gaps gaps(*ellipse, points);
  if (gaps.Coverage() < config.min_coverage) return std::nullopt;
  if (std::erase_if(points, [&](const Eigen::Vector2d& point) { return gaps.IsBeside(point); }) > 0) {
    ellipse = FitEllipse(points);
    if (!ellipse) return std::nullopt;
  }
  const double max_rms = std::max(2.0 * config.tolerance_px, config.max_relative_rms * ellipse->semi_axes.y());
  if (RmsDistance(*ellipse, points) > max_rms) return std::nullopt;
  return ellipse;
}

Eigen::Matrix3d NormalizedConic(const Ellipse& ellipse, const models::CameraModel& camera) {
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = camera.fx_px;
  K(1, 1) = camera.fy_px;
  K(0, 2) = camera.cx_px;
  K(1, 2) = camera.cy_px;
  return K.transpose() * ellipse.Conic() * K;
}

}  // namespace touchdown::estimator::pad
