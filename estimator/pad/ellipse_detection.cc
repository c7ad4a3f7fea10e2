#include "estimator/pad/ellipse_detection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>
#include <utility>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

/// Canny's edge pixels with their gradients.
struct EdgeMap {
  cv::Mat1b edges;
  cv::Mat1s gradient_u, gradient_v;

  EdgeMap(const models::ImageView& image, const EllipseDetectionConfig& config) {
    const cv::Mat gray(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                       static_cast<std::size_t>(image.stride));
    cv::Mat smooth;
    cv::GaussianBlur(gray, smooth, {3, 3}, 0.0);
    cv::Sobel(smooth, gradient_u, CV_16S, 1, 0);
    cv::Sobel(smooth, gradient_v, CV_16S, 0, 1);
    cv::Canny(gradient_u, gradient_v, edges, config.canny_low, config.canny_high, true);
  }

  bool IsEdge(int u, int v) const { return u >= 0 && v >= 0 && u < edges.cols && v < edges.rows && edges(v, u) != 0; }
  Vector2d GradientAt(int u, int v) const { return {gradient_u(v, u), gradient_v(v, u)}; }
};

/// Connected edge pixels along a curve.
struct EdgeSegment {
  std::vector<Vector2d> points;
  Vector2d sum_of_normals = Vector2d::Zero();  // Sum of the unit gradients.

  /// Whether the segment is curved enough to determine an ellipse. On an arc of angle a the mean normal has the length
  /// sin(a/2) / (a/2).
  bool IsCurved() const {
    constexpr double kOfArc45deg = 0.975;
    return sum_of_normals.norm() < kOfArc45deg * static_cast<double>(points.size());
  }
};

/// Whether two gradients have nearly the same direction.
bool AreAligned(const Vector2d& a, const Vector2d& b) {
  constexpr double kMinCosine = 0.85;
  const double dot = a.dot(b);
  return dot > 0.0 && dot * dot > kMinCosine * kMinCosine * a.squaredNorm() * b.squaredNorm();
}

/// Segments of the edge map that are long and curved enough. Neighboring pixels are linked when their gradients have
/// nearly the same direction: a segment ends at a corner and where another edge crosses or touches it.
std::vector<EdgeSegment> LinkEdges(const EdgeMap& map) {
  constexpr std::size_t kMinSegmentPoints = 20;
  cv::Mat1b unvisited = map.edges.clone();
  std::vector<EdgeSegment> segments;
  std::vector<cv::Point> linked;
  for (int v = 0; v < unvisited.rows; ++v) {
    for (int u = 0; u < unvisited.cols; ++u) {
      if (unvisited(v, u) == 0) continue;
      linked.assign(1, {u, v});
      unvisited(v, u) = 0;
      for (std::size_t i = 0; i < linked.size(); ++i) {
        const cv::Point here = linked[i];
        const Vector2d gradient = map.GradientAt(here.x, here.y);
        for (int y = std::max(0, here.y - 1); y <= std::min(unvisited.rows - 1, here.y + 1); ++y) {
          for (int x = std::max(0, here.x - 1); x <= std::min(unvisited.cols - 1, here.x + 1); ++x) {
            if (unvisited(y, x) == 0 || !AreAligned(map.GradientAt(x, y), gradient)) continue;
            unvisited(y, x) = 0;
            linked.push_back({x, y});
          }
        }
      }
      if (linked.size() < kMinSegmentPoints) continue;
      EdgeSegment segment;
      for (const cv::Point& p : linked) {
        segment.points.emplace_back(p.x, p.y);
        segment.sum_of_normals += map.GradientAt(p.x, p.y).normalized();
      }
      if (segment.IsCurved()) segments.push_back(std::move(segment));
    }
  }
  return segments;
}

/// Edge pixels near an ellipse whose bright side is outside, at most one per direction from the center.
struct Inliers {
  std::vector<Vector2d> points;
  double coverage = 0.0;  // Fraction of the directions that have an inlier.
};

Inliers FindInliers(const Ellipse& ellipse, const EdgeMap& map, double max_distance_px) {
  constexpr double kMinAlignment = 0.8;
  const double circumference = models::kPi * ellipse.semi_axes.sum();
  const int directions = std::clamp(static_cast<int>(circumference / 2.0), 24, 180);
  const Eigen::Rotation2Dd from_axes(ellipse.angle);
  Inliers inliers;
  for (int i = 0; i < directions; ++i) {
    const double t = 2.0 * models::kPi * i / directions, c = std::cos(t), s = std::sin(t);
    const Vector2d outwards = from_axes * Vector2d(c / ellipse.semi_axes.x(), s / ellipse.semi_axes.y()).normalized();
    const Vector2d on_ellipse =
        ellipse.center + from_axes * Vector2d(c * ellipse.semi_axes.x(), s * ellipse.semi_axes.y());
    std::optional<Vector2d> nearest;
    for (int k = 0; k <= 4 * static_cast<int>(max_distance_px) && !nearest; ++k) {
      const int half_pixels = (k + 1) / 2;
      const double outward_px = (k % 2 == 0 ? -0.5 : 0.5) * half_pixels;  // 0, 0.5, -0.5, 1, -1, ...
      const Vector2d p = on_ellipse + outward_px * outwards;
      const int u = static_cast<int>(std::lround(p.x())), v = static_cast<int>(std::lround(p.y()));
      if (!map.IsEdge(u, v)) continue;
      const Vector2d gradient = map.GradientAt(u, v);
      if (gradient.dot(outwards) > kMinAlignment * gradient.norm()) nearest = Vector2d(u, v);
    }
    if (nearest) inliers.points.push_back(*nearest);
  }
  inliers.coverage = static_cast<double>(inliers.points.size()) / directions;
  return inliers;
}

/// Finds the ring that an edge segment belongs to.
class RingFitter {
 public:
  RingFitter(const EdgeMap& map, const EllipseDetectionConfig& config) : map_(map), config_(config) {}

  /// Coverage and ellipse of the ring through a segment; nullopt if there is none.
  std::optional<std::pair<double, Ellipse>> RingThrough(std::span<const Vector2d> segment) const {
    auto ellipse = FitEllipse(segment);
    if (!ellipse || !IsPossible(*ellipse) || !FollowsBoundary(segment, *ellipse)) return std::nullopt;
    Inliers inliers;
    for (const double relative_distance : {0.15, 0.08, 0.05, 0.04}) {
      inliers = FindInliers(*ellipse, map_, std::max(2.0, relative_distance * ellipse->semi_axes.y()));
      if (inliers.coverage < 0.5 * config_.min_coverage) return std::nullopt;
      ellipse = FitEllipse(inliers.points);
      if (!ellipse || !IsPossible(*ellipse)) return std::nullopt;
    }
    if (inliers.coverage < config_.min_coverage) return std::nullopt;
    return std::pair(inliers.coverage, *ellipse);
  }

 private:
  bool IsPossible(const Ellipse& ellipse) const {
    const Vector2d& axes = ellipse.semi_axes;
    const Vector2d half_box = ellipse.Shape().diagonal().cwiseSqrt();
    const Vector2d low = ellipse.center - half_box, high = ellipse.center + half_box;
    const bool is_inside_image =
        low.minCoeff() >= 0.0 && high.x() <= map_.edges.cols - 1 && high.y() <= map_.edges.rows - 1;
    return axes.y() >= config_.min_semi_axis_px && axes.y() >= config_.min_axis_ratio * axes.x() && is_inside_image;
  }

  /// Whether the segment lies on the ellipse, with its bright side outside.
  bool FollowsBoundary(std::span<const Vector2d> segment, const Ellipse& ellipse) const {
    constexpr double kMaxRelativeRms = 0.06, kMinOutwards = 0.8;
    if (RmsDistance(ellipse, segment) > std::max(1.0, kMaxRelativeRms * ellipse.semi_axes.y())) return false;
    const auto outwards = std::count_if(segment.begin(), segment.end(), [&](const Vector2d& p) {
      return map_.GradientAt(static_cast<int>(p.x()), static_cast<int>(p.y())).dot(p - ellipse.center) > 0.0;
    });
    return static_cast<double>(outwards) >= kMinOutwards * static_cast<double>(segment.size());
  }

  const EdgeMap& map_;
  const EllipseDetectionConfig& config_;
};

bool AreSame(const Ellipse& a, const Ellipse& b) {
  const double near_px = std::max(2.0, 0.04 * a.semi_axes.y());
  return (a.center - b.center).norm() < near_px && (a.semi_axes - b.semi_axes).cwiseAbs().maxCoeff() < near_px;
}

}  // namespace

void EllipseDetectionConfig::Validate() const {
  for (const double value : {canny_low, canny_high, min_coverage, min_semi_axis_px, min_axis_ratio}) {
    if (!std::isfinite(value) || value <= 0.0)
      throw InputError("the limits of the ellipse detection must be positive and finite");
  }
  if (canny_high < canny_low) throw InputError("canny_low must be at most canny_high");
  if (min_coverage > 1.0) throw InputError("min_coverage must be at most 1");
  if (min_axis_ratio > 1.0) throw InputError("min_axis_ratio must be at most 1");
  if (max_rings < 1) throw InputError("max_rings must be at least 1");
}

std::vector<Ellipse> DetectEllipses(const models::ImageView& image, const EllipseDetectionConfig& config) {
  const EdgeMap map(image, config);
  const RingFitter fitter(map, config);
  std::vector<std::pair<double, Ellipse>> rings;  // Coverage and ellipse.
  for (const EdgeSegment& segment : LinkEdges(map)) {
    if (const auto ring = fitter.RingThrough(segment.points)) rings.push_back(*ring);
  }
  std::stable_sort(rings.begin(), rings.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Ellipse> distinct;
  for (const auto& [coverage, ring] : rings) {
    const auto is_same = [&ring = ring](const Ellipse& other) { return AreSame(other, ring); };
    if (static_cast<int>(distinct.size()) < config.max_rings && std::none_of(distinct.begin(), distinct.end(), is_same))
      distinct.push_back(ring);
  }
  return distinct;
}

}  // namespace touchdown::estimator::pad
