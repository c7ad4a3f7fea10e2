#include "estimator/paper/letter_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kRadii = 20;
constexpr int kAngles = 120;
constexpr int kHalfTurn = kAngles / 2;  // An H looks the same after it.
constexpr double kReach = 2.4;          // Of the grid, in standard deviations of the shape: an H's corners are within 2.

/// The grid's points in a shape whose spread is the identity. Every ring covers the same area, so that all weigh alike.
Vector2d GridPoint(int ring, int spoke) {
  const double radius = kReach * std::sqrt((ring + 0.5) / kRadii), angle = 2.0 * models::kPi * spoke / kAngles;
  return radius * Vector2d(std::cos(angle), std::sin(angle));
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

template <typename Sample>
std::vector<float> OnGrid(const ShapeMoments& moments, const Sample& sample) {
  const Matrix2d from_grid = SquareRoot(moments.spread);
  std::vector<float> samples;
  samples.reserve(kRadii * kAngles);
  for (int ring = 0; ring < kRadii; ++ring) {
    for (int spoke = 0; spoke < kAngles; ++spoke) {
      samples.push_back(static_cast<float>(sample(moments.mean + from_grid * GridPoint(ring, spoke))));
    }
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

}  // namespace

ShapeMoments MomentsOf(const ComponentSet& components, const Component& component) {
  const Vector2d origin(component.u, component.v);
  Vector2d sum = Vector2d::Zero();
  Matrix2d squares = Matrix2d::Zero();
  for (const Run& run : components.RunsOf(component)) {
    const double n = run.u_end - run.u_begin;
    const Vector2d middle = Vector2d(0.5 * (run.u_begin + run.u_end - 1), run.v) - origin;
    sum += n * middle;
    squares += n * middle * middle.transpose();
    squares(0, 0) += n * n * n / 12.0;
    squares(1, 1) += n / 12.0;
  }
  const Vector2d mean = sum / component.area;
  return {origin + mean, squares / component.area - mean * mean.transpose()};
}

void LetterCheckConfig::Validate() const {
  if (!(least_resemblance > 0.0 && least_resemblance < 1.0)) {
    throw InputError("the least resemblance of a letter to the pad's H must be within (0, 1)");
  }
  if (!std::isfinite(largest_size_error) || largest_size_error < 1.0) {
    throw InputError("the largest error of a letter's size must be at least 1");
  }
}

LetterCheck::LetterCheck(const models::LandingPad& pad, const LetterCheckConfig& config) : config_(config) {
  const ShapeMoments moments = MomentsOfH(pad);
  const Vector2d spreads = moments.spread.diagonal().cwiseSqrt() / pad.outer_radius_m;
  size_ratios_ = Vector2d(spreads.minCoeff(), spreads.maxCoeff());
  expected_ = OnGrid(moments, [&](const Vector2d& p) { return p.norm() < pad.inner_radius_m() && pad.IsBlack(p) ? 1.0 : 0.0; });
  expected_norm_ = Centre(expected_);
}

bool LetterCheck::Passes(const ComponentSet& components, const Component& letter, const ShapeMoments& moments,
                         const Matrix2d& ring_shape) const {
  if (std::getenv("CHECK")) std::fprintf(stderr, "CHECK %.3f %.3f %d %d\n", Resemblance(components, letter), SizeError(moments, ring_shape), letter.width, letter.height);
  return SizeError(moments, ring_shape) <= config_.largest_size_error &&
         Resemblance(components, letter) >= config_.least_resemblance;
}

double LetterCheck::Resemblance(const ComponentSet& components, const Component& letter) const {
  const Mask mask(components, letter);
  std::vector<float> seen = OnGrid(MomentsOf(components, letter), [&](const Vector2d& p) { return mask.At(p); });
  const double seen_norm = Centre(seen);
  if (seen_norm == 0.0) return -1.0;
  double best = -1.0;
  for (int turn = 0; turn < kHalfTurn; ++turn) best = std::max(best, ProductAtTurn(expected_, seen, turn));
  return best / (expected_norm_ * seen_norm);
}

double LetterCheck::SizeError(const ShapeMoments& letter, const Matrix2d& ring_shape) const {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix2d> eigen(letter.spread, ring_shape);
  const Eigen::Array2d error = (eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().array() / size_ratios_.array());
  return std::max(error.maxCoeff(), 1.0 / error.minCoeff());
}

}  // namespace touchdown::estimator
