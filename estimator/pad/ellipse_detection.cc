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

  EdgeMap(const models::ImageView& image, const RingSearchConfig& config) {
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

/// Edge pixels that follow one another along a curve.
struct Chain {
  std::vector<Vector2d> points;
  Vector2d sum_of_normals = Vector2d::Zero();  // Unit gradients.

  /// Whether it turns enough to tell an ellipse: over an arc of angle a the normals' mean has a length of
  /// sin(a/2) / (a/2).
  bool IsBent() const {
    constexpr double kOfArc45deg = 0.975;
    return sum_of_normals.norm() < kOfArc45deg * static_cast<double>(points.size());
  }
};

/// Whether two gradients point nearly the same way.
bool AreAligned(const Vector2d& a, const Vector2d& b) {
  constexpr double kLeastCosine = 0.85;
  const double dot = a.dot(b);
  return dot > 0.0 && dot * dot > kLeastCosine * kLeastCosine * a.squaredNorm() * b.squaredNorm();
}

/// Edge pixels linked to neighbors whose gradients point nearly the same way: a chain ends at a corner, and where
/// another edge crosses or touches. Only those long and bent enough.
std::vector<Chain> ChainsOf(const EdgeMap& map) {
  constexpr std::size_t kFewestOfChain = 20;
  cv::Mat1b waiting = map.edges.clone();
  std::vector<Chain> chains;
  std::vector<cv::Point> linked;
  for (int v = 0; v < waiting.rows; ++v) {
    for (int u = 0; u < waiting.cols; ++u) {
      if (waiting(v, u) == 0) continue;
      linked.assign(1, {u, v});
      waiting(v, u) = 0;
      for (std::size_t i = 0; i < linked.size(); ++i) {
        const cv::Point here = linked[i];
        const Vector2d gradient = map.GradientAt(here.x, here.y);
        for (int y = std::max(0, here.y - 1); y <= std::min(waiting.rows - 1, here.y + 1); ++y) {
          for (int x = std::max(0, here.x - 1); x <= std::min(waiting.cols - 1, here.x + 1); ++x) {
            if (waiting(y, x) == 0 || !AreAligned(map.GradientAt(x, y), gradient)) continue;
            waiting(y, x) = 0;
            linked.push_back({x, y});
          }
        }
      }
      if (linked.size() < kFewestOfChain) continue;
      Chain chain;
      for (const cv::Point& p : linked) {
        chain.points.emplace_back(p.x, p.y);
        chain.sum_of_normals += map.GradientAt(p.x, p.y).normalized();
      }
      if (chain.IsBent()) chains.push_back(std::move(chain));
    }
  }
  return chains;
}

/// Edge pixels near an ellipse that are bright outwards, at most one in each direction from the center.
struct Support {
  std::vector<Vector2d> points;
  double coverage = 0.0;
};

Support SupportOf(const Ellipse& ellipse, const EdgeMap& map, double reach_px) {
  constexpr double kLeastAlignment = 0.8;
  const double circumference = models::kPi * ellipse.semi_axes.sum();
  const int directions = std::clamp(static_cast<int>(circumference / 2.0), 24, 180);
  const Eigen::Rotation2Dd from_axes(ellipse.angle);
  Support support;
  for (int i = 0; i < directions; ++i) {
    const double t = 2.0 * models::kPi * i / directions, c = std::cos(t), s = std::sin(t);
    const Vector2d outwards = from_axes * Vector2d(c / ellipse.semi_axes.x(), s / ellipse.semi_axes.y()).normalized();
    const Vector2d place = ellipse.center + from_axes * Vector2d(c * ellipse.semi_axes.x(), s * ellipse.semi_axes.y());
    std::optional<Vector2d> nearest;
    for (int k = 0; k <= 4 * static_cast<int>(reach_px) && !nearest; ++k) {
      const double outward_px = (k % 2 == 0 ? -0.5 : 0.5) * ((k + 1) / 2);  // 0, 0.5, -0.5, 1, -1, ...
      const Vector2d p = place + outward_px * outwards;
      const int u = static_cast<int>(std::lround(p.x())), v = static_cast<int>(std::lround(p.y()));
      if (!map.IsEdge(u, v)) continue;
      const Vector2d gradient = map.GradientAt(u, v);
      if (gradient.dot(outwards) > kLeastAlignment * gradient.norm()) nearest = Vector2d(u, v);
    }
    if (nearest) support.points.push_back(*nearest);
  }
  support.coverage = static_cast<double>(support.points.size()) / directions;
  return support;
}

class RingFinder {
 public:
  RingFinder(const EdgeMap& map, const RingSearchConfig& config) : map_(map), config_(config) {}

  /// The ring of which a chain of edges may be part.
  std::optional<std::pair<double, Ellipse>> RingThrough(std::span<const Vector2d> chain) const {
    auto ellipse = FitEllipse(chain);
    if (!ellipse || !IsPossible(*ellipse) || !FollowsBoundary(chain, *ellipse)) return std::nullopt;
    Support support;
    for (const double reach_share : {0.15, 0.08, 0.05, 0.04}) {
      support = SupportOf(*ellipse, map_, std::max(2.0, reach_share * ellipse->semi_axes.y()));
      if (support.coverage < 0.5 * config_.least_coverage) return std::nullopt;
      ellipse = FitEllipse(support.points);
      if (!ellipse || !IsPossible(*ellipse)) return std::nullopt;
    }
    if (support.coverage < config_.least_coverage) return std::nullopt;
    return std::pair(support.coverage, *ellipse);
  }

 private:
  bool IsPossible(const Ellipse& ellipse) const {
    const Vector2d& axes = ellipse.semi_axes;
    const Vector2d half_box = ellipse.Shape().diagonal().cwiseSqrt();
    const Vector2d low = ellipse.center - half_box, high = ellipse.center + half_box;
    const bool is_seen_whole =
        low.minCoeff() >= 0.0 && high.x() <= map_.edges.cols - 1 && high.y() <= map_.edges.rows - 1;
    return axes.y() >= config_.smallest_semi_axis_px && axes.y() >= config_.least_axis_ratio * axes.x() &&
           is_seen_whole;
  }

  bool FollowsBoundary(std::span<const Vector2d> chain, const Ellipse& ellipse) const {
    constexpr double kLargestRmsShare = 0.06, kLeastOutwards = 0.8;
    if (RmsDistance(ellipse, chain) > std::max(1.0, kLargestRmsShare * ellipse.semi_axes.y())) return false;
    const auto outwards = std::count_if(chain.begin(), chain.end(), [&](const Vector2d& p) {
      return map_.GradientAt(static_cast<int>(p.x()), static_cast<int>(p.y())).dot(p - ellipse.center) > 0.0;
    });
    return static_cast<double>(outwards) >= kLeastOutwards * static_cast<double>(chain.size());
  }

  const EdgeMap& map_;
  const RingSearchConfig& config_;
};

bool AreSame(const Ellipse& a, const Ellipse& b) {
  const double near_px = std::max(2.0, 0.04 * a.semi_axes.y());
  return (a.center - b.center).norm() < near_px && (a.semi_axes - b.semi_axes).cwiseAbs().maxCoeff() < near_px;
}

}  // namespace

void RingSearchConfig::Validate() const {
  for (const double value : {canny_low, canny_high, least_coverage, smallest_semi_axis_px, least_axis_ratio}) {
    if (!std::isfinite(value) || value <= 0.0) throw InputError("the ring search's limits must be positive and finite");
  }
  if (canny_high < canny_low) throw InputError("the ring search's Canny thresholds must be in order");
  if (least_coverage > 1.0) throw InputError("edges cannot cover more than the whole ring");
  if (least_axis_ratio > 1.0) throw InputError("a ring's minor axis is not longer than its major one");
  if (most_rings < 1) throw InputError("the ring search must hand on a ring at least");
}

std::vector<Ellipse> DetectEllipses(const models::ImageView& image, const RingSearchConfig& config) {
  const EdgeMap map(image, config);
  const RingFinder finder(map, config);
  std::vector<std::pair<double, Ellipse>> rings;  // With their coverage.
  for (const Chain& chain : ChainsOf(map)) {
    if (const auto ring = finder.RingThrough(chain.points)) rings.push_back(*ring);
  }
  std::stable_sort(rings.begin(), rings.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Ellipse> distinct;
  for (const auto& [coverage, ring] : rings) {
    const auto is_same = [&ring = ring](const Ellipse& other) { return AreSame(other, ring); };
    if (static_cast<int>(distinct.size()) < config.most_rings &&
        std::none_of(distinct.begin(), distinct.end(), is_same))
      distinct.push_back(ring);
  }
  return distinct;
}

}  // namespace touchdown::estimator::pad
