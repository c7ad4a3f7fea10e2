#include "sim/scene/grass_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "models/angles.h"
#include "models/random_stream.h"
#include "sim/scene/lattice_noise.h"

namespace touchdown::sim {
namespace {

constexpr double kPathWobble_m = 0.05;
constexpr double kPathToSheet_m = 0.06;
constexpr double kSlabLength_m = 0.42;
constexpr double kSlabJoint_m = 0.03;
/// Largest texel at which individual blades are drawn, m.
constexpr double kMaxBladeTexel_m = 0.003;
constexpr double kBladesPerM2 = 22000.0;

Eigen::Vector2d TexelCenter(int column, int row, double side_m, int texels) {
  return side_m * Eigen::Vector2d((column + 0.5) / texels - 0.5, 0.5 - (row + 0.5) / texels);
}

cv::Vec3b Color(const Eigen::Vector3d& reflectance) {
  return {cv::saturate_cast<std::uint8_t>(reflectance.x()), cv::saturate_cast<std::uint8_t>(reflectance.y()),
          cv::saturate_cast<std::uint8_t>(reflectance.z())};
}

/// Distances to the nearest and the second nearest of random points, one per cell, and the value of the nearest.
struct Nearest {
  double first = 9.0, second = 9.0, value = 0.0;
};

Nearest NearestPoint(double x, double y, std::uint32_t seed) {
  Nearest nearest;
  const double column = std::floor(x), row = std::floor(y);
  for (double cy = row - 1.0; cy <= row + 1.0; ++cy) {
    for (double cx = column - 1.0; cx <= column + 1.0; ++cx) {
      const double distance = std::hypot(cx + CellValue(cx, cy, seed) - x, cy + CellValue(cx, cy, seed + 1) - y);
      if (distance < nearest.first) {
        nearest = {distance, nearest.first, CellValue(cx, cy, seed + 2)};
      } else {
        nearest.second = std::min(nearest.second, distance);
      }
    }
  }
  return nearest;
}

}  // namespace

GrassPattern::GrassPattern(std::uint64_t seed, const models::LandingPad& pad) {
  models::RandomStream random(seed, "grass");
  seed_ = static_cast<std::uint32_t>(random.Bits());
  const double dryness = random.Uniform(0.0, 1.0);
  green_ = random.Uniform(0.85, 1.2) * Eigen::Vector3d(52.0 + 40.0 * dryness, 88.0 + 12.0 * dryness, 30.0);
  path_ = random.Bernoulli(0.5) ? Path::kGravel : Path::kSlabs;
  path_gray_ = random.Uniform(95.0, 150.0);
  const double heading = random.Uniform(-models::kPi, models::kPi);
  path_along_ << std::cos(heading), std::sin(heading);
  path_left_ << -path_along_.y(), path_along_.x();
  path_half_width_m_ = random.Uniform(0.15, 0.25);
  const double clear_m = 0.5 * std::hypot(pad.sheet_length_m, pad.sheet_width_m) + kPathToSheet_m + kPathWobble_m;
  path_distance_m_ = clear_m + path_half_width_m_ + random.Uniform(0.0, 0.25);
  stone_m_ = random.Uniform(0.018, 0.03);
}

/// Coordinates along the path and from its center line to the left, m.
Eigen::Vector2d GrassPattern::AlongAndAcross(const Eigen::Vector2d& p_W) const {
  return {path_along_.dot(p_W), path_left_.dot(p_W) - path_distance_m_};
}

bool GrassPattern::IsPath(const Eigen::Vector2d& p_W) const {
  const Eigen::Vector2d p = AlongAndAcross(p_W);
  if (std::abs(p.y()) > path_half_width_m_ + kPathWobble_m) return false;
  if (path_ == Path::kGravel) {
    return std::abs(p.y()) <
           path_half_width_m_ + kPathWobble_m * FractalNoise(p.x() / 0.25, p.y() / 0.25, 3, seed_ + 20);
  }
  const double along = p.x() / kSlabLength_m;
  const double to_end_m = kSlabLength_m * std::abs(along - std::round(along));
  const double ragged_m = 0.006 * SmoothNoise(p.x() / 0.04, p.y() / 0.04, seed_ + 20);
  return std::abs(p.y()) < path_half_width_m_ + ragged_m && to_end_m > 0.5 * kSlabJoint_m + ragged_m;
}

/// Reflectance of the grass without individual blades: clumps, worn places, tufts.
Eigen::Vector3d GrassPattern::Turf(const Eigen::Vector2d& p) const {
  const double meadow = FractalNoise(p.x() / 1.1, p.y() / 1.1, 2, seed_);
  const double clump = FractalNoise(p.x() / 0.16, p.y() / 0.16, 3, seed_ + 3);
  const double tuft = FractalNoise(p.x() / 0.03, p.y() / 0.03, 2, seed_ + 7);
  const double worn = std::clamp(4.0 * FractalNoise(p.x() / 0.45, p.y() / 0.45, 3, seed_ + 11) - 1.2, 0.0, 1.0);
  const Eigen::Vector3d soil(84.0, 68.0, 50.0);
  const Eigen::Vector3d grass = (1.0 + 0.35 * meadow + 0.6 * clump) * green_;
  return (1.0 + 0.5 * tuft) * (grass + 0.7 * worn * (soil - grass));
}

cv::Mat3b GrassPattern::PaintTurf(double side_m, int texels) const {
  constexpr double kCoarsest_m = 0.010;
  const int nodes = std::clamp(static_cast<int>(std::ceil(side_m / kCoarsest_m)), texels / 4, texels);
  cv::Mat3b turf(nodes, nodes), texture;
  for (int row = 0; row < nodes; ++row) {
    for (int column = 0; column < nodes; ++column) {
      turf(row, column) = Color(Turf(TexelCenter(column, row, side_m, nodes)));
    }
  }
  cv::resize(turf, texture, {texels, texels}, 0, 0, cv::INTER_LINEAR);
  return texture;
}

/// Direction in which a blade leans, rad. It varies smoothly with position, plus `deviation`.
double GrassPattern::Lean(const Eigen::Vector2d& p, double deviation) const {
  return 4.0 * SmoothNoise(p.x() / 0.20, p.y() / 0.20, seed_ + 15) + deviation;
}

/// Draws blades that are lighter or darker than the turf, and darkens the turf as if in their shade.
void GrassPattern::GrowBlades(double side_m, cv::Mat3b& texture) const {
  constexpr int kFractionBits = 4;
  constexpr double kGround = 0.6;
  const cv::Mat3b turf = texture.clone();
  texture.convertTo(texture, CV_8U, kGround);
  models::RandomStream random(seed_, "blades");
  const double texels_per_m = texture.cols / side_m;
  const int blades = static_cast<int>(kBladesPerM2 * side_m * side_m);
  for (int i = 0; i < blades; ++i) {
    const Eigen::Vector2d root(random.Uniform(0.0, texture.cols), random.Uniform(0.0, texture.rows));
    const double direction = Lean(root / texels_per_m, random.Uniform(-1.3, 1.3)), length = random.Uniform(0.02, 0.07);
    const Eigen::Vector2d tip =
        root + length * texels_per_m * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    const cv::Vec3b& under = turf(static_cast<int>(root.y()), static_cast<int>(root.x()));
    const double light = random.Uniform(0.65, 1.5), dry = random.Bernoulli(0.05) ? 1.4 : 1.0;
    const auto fixed = [](const Eigen::Vector2d& p) {
      return cv::Point(static_cast<int>((1 << kFractionBits) * p.x()), static_cast<int>((1 << kFractionBits) * p.y()));
    };
    cv::line(texture, fixed(root), fixed(tip), cv::Scalar(dry * light * under[0], light * under[1], light * under[2]),
             random.Bernoulli(0.3) ? 2 : 1, cv::LINE_AA, kFractionBits);
  }
}

double GrassPattern::Gravel(const Eigen::Vector2d& p) const {
  const Nearest stone = NearestPoint(p.x() / stone_m_, p.y() / stone_m_, seed_ + 30);
  const double gap = std::clamp(5.0 * (stone.second - stone.first), 0.3, 1.0);
  return gap * path_gray_ * (0.55 + 0.9 * stone.value);
}

double GrassPattern::Slab(const Eigen::Vector2d& p) const {
  const double slab = std::floor(p.x() / kSlabLength_m);
  const double tone = 0.8 + 0.4 * CellValue(slab, 0.0, seed_ + 40);
  const double stain = FractalNoise(p.x() / 0.12, p.y() / 0.12, 3, seed_ + 41);
  const double grain = SmoothNoise(p.x() / 0.005, p.y() / 0.005, seed_ + 45);
  return path_gray_ * tone * (1.0 + 0.35 * stain + 0.10 * grain);
}

void GrassPattern::LayPath(double side_m, cv::Mat3b& texture) const {
  for (int row = 0; row < texture.rows; ++row) {
    for (int column = 0; column < texture.cols; ++column) {
      const Eigen::Vector2d p_W = TexelCenter(column, row, side_m, texture.cols);
      if (!IsPath(p_W)) continue;
      const Eigen::Vector2d p = AlongAndAcross(p_W);
      const double gray = path_ == Path::kGravel ? Gravel(p) : Slab(p);
      texture(row, column) = Color(gray * Eigen::Vector3d(1.0, 0.97, 0.90));
    }
  }
}

cv::Mat3b GrassPattern::Paint(double side_m, int texels) const {
  cv::Mat3b texture = PaintTurf(side_m, texels);
  if (side_m / texels <= kMaxBladeTexel_m) GrowBlades(side_m, texture);
  LayPath(side_m, texture);
  return texture;
}

}  // namespace touchdown::sim
