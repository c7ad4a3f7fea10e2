#include "estimator/paper/letter_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kRadii = 20;
constexpr int kAngles = 120;
constexpr int kHalfTurn = kAngles / 2;  // An H looks the same after it.
constexpr double kReach = 2.4;  // Of the grid, in standard deviations of the shape: an H's corners are within 2.

/// A shape's mean place and its spread, the covariance of its points.
struct ShapeMoments {
  Vector2d mean = Vector2d::Zero();
  Matrix2d spread = Matrix2d::Identity();
};

/// The plane of a ring, its origin the ring's centre, as the components show it.
class SeenPlane {
 public:
  SeenPlane(const CirclePose& ring_pose, const ComponentView& view)
      : pose_(ring_pose), x_C_(ring_pose.n_C.unitOrthogonal()), y_C_(ring_pose.n_C.cross(x_C_)), view_(view) {}

  /// In the plane, with the depth below the camera as third coordinate.
  Vector3d PointAt(const Vector2d& pixel) const {
    const Vector2d raw = view_.reduction * (pixel + Vector2d::Constant(0.5)) - Vector2d::Constant(0.5);
    const Vector3d ray_C = view_.camera.NormalizedFromPixel(view_.undistort.At(raw)).homogeneous();
    const Vector3d p_C = ray_C * (pose_.n_C.dot(pose_.p_CW) / pose_.n_C.dot(ray_C));
    return {x_C_.dot(p_C - pose_.p_CW), y_C_.dot(p_C - pose_.p_CW), p_C.z()};
  }

  std::optional<Vector2d> PixelAt(const Vector2d& point) const {
    const auto raw = view_.camera.Project(pose_.p_CW + point.x() * x_C_ + point.y() * y_C_);
    if (!raw) return std::nullopt;
    return (*raw + Vector2d::Constant(0.5)) / view_.reduction - Vector2d::Constant(0.5);
  }

 private:
  const CirclePose& pose_;
  Vector3d x_C_, y_C_;
  const ComponentView& view_;
};

/// Of the component's pixels, laid back on the plane: one at depth z covers an area there that grows with z^3.
ShapeMoments MomentsOn(const SeenPlane& plane, const ComponentSet& components, const Component& component) {
  double area = 0.0;
  Vector2d sum = Vector2d::Zero();
  Matrix2d squares = Matrix2d::Zero();
  for (const Run& run : components.RunsOf(component)) {
    const Vector3d begin = plane.PointAt({run.u_begin - 0.5, run.v}), end = plane.PointAt({run.u_end - 0.5, run.v});
    const Vector3d middle = 0.5 * (begin + end);
    const Vector2d along = (end - begin).head<2>(), p = middle.head<2>();
    const double weight = (run.u_end - run.u_begin) * std::pow(middle.z(), 3);
    area += weight;
    sum += weight * p;
    squares += weight * (p * p.transpose() + along * along.transpose() / 12.0);
  }
  const Vector2d mean = sum / area;
  return {mean, squares / area - mean * mean.transpose()};
}

/// The grid's points in a shape whose spread is the identity. Every ring covers the same area, so that all weigh alike.
const std::vector<Vector2d>& Grid() {
  static const std::vector<Vector2d> grid = [] {
    std::vector<Vector2d> points;
    for (int ring = 0; ring < kRadii; ++ring) {
      const double radius = kReach * std::sqrt((ring + 0.5) / kRadii);
      for (int spoke = 0; spoke < kAngles; ++spoke) {
        const double angle = 2.0 * models::kPi * spoke / kAngles;
        points.push_back(radius * Vector2d(std::cos(angle), std::sin(angle)));
      }
    }
    return points;
  }();
  return grid;
}

/// Points, in units of the pad, of the H's area: strokes and bar.
ShapeMoments MomentsOfH(const models::LandingPad& pad) {
  const double inner_width = pad.h_width_m - 2.0 * pad.h_stroke_m;
  const double strokes = 2.0 * pad.h_height_m * pad.h_stroke_m, bar = inner_width * pad.h_stroke_m;
  const double offset = 0.5 * (pad.h_width_m - pad.h_stroke_m);
  const auto second = [](double side) { return side * side / 12.0; };
  const double along = strokes * second(pad.h_height_m) + bar * second(pad.h_stroke_m);
  const double across = strokes * (second(pad.h_stroke_m) + offset * offset) + bar * second(inner_width);
  ShapeMoments moments;
  moments.spread = Vector2d(along, across).asDiagonal();
  moments.spread /= strokes + bar;
  return moments;
}

Matrix2d SquareRoot(const Matrix2d& spread) { return Eigen::SelfAdjointEigenSolver<Matrix2d>(spread).operatorSqrt(); }

/// The component's pixels, 1, in a frame of zeros.
class Mask {
 public:
  Mask(const ComponentSet& components, const Component& component)
      : u_(component.u - 1),
        v_(component.v - 1),
        width_(component.width + 2),
        height_(component.height + 2),
        cells_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {
    for (const Run& run : components.RunsOf(component)) {
      const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(run.v - v_) * width_ + (run.u_begin - u_);
      std::fill(begin, begin + (run.u_end - run.u_begin), std::uint8_t{1});
    }
  }

  /// Interpolated bilinearly.
  double At(const Vector2d& p) const {
    const double x = p.x() - u_, y = p.y() - v_;
    if (!(x >= 0.0 && y >= 0.0 && x < width_ - 1 && y < height_ - 1)) return 0.0;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double a = x - i, b = y - j;
    const std::uint8_t* upper = cells_.data() + static_cast<std::ptrdiff_t>(j) * width_ + i;
    const std::uint8_t* lower = upper + width_;
    return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
  }

 private:
  int u_, v_, width_, height_;
  std::vector<std::uint8_t> cells_;
};

/// Subtracts the mean; the norm of what remains.
double Centre(std::vector<float>& samples) {
  double sum = 0.0, squares = 0.0;
  for (const float sample : samples) sum += sample;
  const auto mean = static_cast<float>(sum / static_cast<double>(samples.size()));
  for (float& sample : samples) {
    sample -= mean;
    squares += sample * sample;
  }
  return std::sqrt(squares);
}

/// `sample` at every point of the grid, stretched to the shape of these moments.
template <typename Sample>
std::vector<float> OnGrid(const ShapeMoments& moments, const Sample& sample) {
  const Matrix2d from_grid = SquareRoot(moments.spread);
  std::vector<float> samples;
  samples.reserve(Grid().size());
  for (const Vector2d& point : Grid()) {
    samples.push_back(static_cast<float>(sample(moments.mean + from_grid * point)));
  }
  return samples;
}

double ProductAtTurn(const std::vector<float>& a, const std::vector<float>& b, int turn) {
  float product = 0.0F;
  for (int ring = 0; ring < kRadii; ++ring) {
    const float* a_row = a.data() + ring * kAngles;
    const float* b_row = b.data() + ring * kAngles;
    for (int spoke = 0; spoke < kAngles - turn; ++spoke) product += a_row[spoke] * b_row[spoke + turn];
    for (int spoke = kAngles - turn; spoke < kAngles; ++spoke) product += a_row[spoke] * b_row[spoke + turn - kAngles];
  }
  return product;
}

/// Of the samples with their mirror image about the axis through spoke `axis`.
double ProductWithMirrored(const std::vector<float>& samples, int axis) {
  float product = 0.0F;
  for (int ring = 0; ring < kRadii; ++ring) {
    const float* row = samples.data() + ring * kAngles;
    for (int spoke = 0; spoke < kAngles; ++spoke) product += row[spoke] * row[(2 * axis + kAngles - spoke) % kAngles];
  }
  return product;
}

}  // namespace

void LetterCheckConfig::Validate() const {
  for (const double least : {least_resemblance, least_symmetry}) {
    if (!(least > 0.0 && least < 1.0)) {
      throw InputError("a letter's least resemblance to the pad's H, and its least symmetry, must be within (0, 1)");
    }
  }
  if (!std::isfinite(largest_size_error) || largest_size_error < 1.0) {
    throw InputError("the largest error of a letter's size must be at least 1");
  }
}

LetterCheck::LetterCheck(const models::LandingPad& pad, const LetterCheckConfig& config) : config_(config) {
  const ShapeMoments moments = MomentsOfH(pad);
  const Vector2d sizes = moments.spread.diagonal().cwiseSqrt();
  sizes_m_ = Vector2d(sizes.minCoeff(), sizes.maxCoeff());
  expected_ =
      OnGrid(moments, [&](const Vector2d& p) { return p.norm() < pad.inner_radius_m() && pad.IsBlack(p) ? 1.0 : 0.0; });
  expected_norm_ = Centre(expected_);
}

LetterCheck::Fit LetterCheck::FitOn(const CirclePose& ring_pose, const ComponentSet& components,
                                    const Component& letter, const ComponentView& view) const {
  const SeenPlane plane(ring_pose, view);
  const ShapeMoments moments = MomentsOn(plane, components, letter);
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(moments.spread);
  if (!(eigen.eigenvalues()(0) > 0.0)) return {};
  const Eigen::Array2d ratios = eigen.eigenvalues().cwiseSqrt().array() / sizes_m_.array();
  Fit fit{.size_error = std::max(ratios.maxCoeff(), 1.0 / ratios.minCoeff())};

  const Mask mask(components, letter);
  bool all_seen = true;
  std::vector<float> seen = OnGrid(moments, [&](const Vector2d& p) {
    const auto pixel = plane.PixelAt(p);
    all_seen = all_seen && pixel;
    return pixel ? mask.At(*pixel) : 0.0;
  });
  const double seen_norm = Centre(seen);
  if (!all_seen || seen_norm == 0.0) return fit;
  int best_turn = 0;
  double best = -1.0;
  for (int turn = 0; turn < kHalfTurn; ++turn) {
    const double product = ProductAtTurn(expected_, seen, turn);
    if (product > best) best_turn = turn;
    best = std::max(best, product);
  }
  fit.resemblance = best / (expected_norm_ * seen_norm);
  fit.symmetry = std::min(ProductWithMirrored(seen, best_turn), ProductWithMirrored(seen, best_turn + kHalfTurn / 2)) /
                 (seen_norm * seen_norm);
  return fit;
}

bool LetterCheck::Passes(const std::array<CirclePose, 2>& ring_poses, const ComponentSet& components,
                         const Component& letter, const ComponentView& view) const {
  // A letter of so few pixels keeps little of its shape.
  constexpr int kLegible_px = 12;
  const bool legible = std::min(letter.width, letter.height) >= kLegible_px;
  const double least_resemblance = legible ? config_.least_resemblance : 0.75 * config_.least_resemblance;
  const double least_symmetry = legible ? config_.least_symmetry : 0.5 * config_.least_symmetry;
  const double largest_size_error = legible ? config_.largest_size_error : 1.3 * config_.largest_size_error;
  return std::any_of(ring_poses.begin(), ring_poses.end(), [&](const CirclePose& pose) {
    const Fit fit = FitOn(pose, components, letter, view);
    return fit.size_error <= largest_size_error && fit.resemblance >= least_resemblance &&
           fit.symmetry >= least_symmetry;
  });
}

}  // namespace touchdown::estimator
