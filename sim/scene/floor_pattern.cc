#include "sim/scene/floor_pattern.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "sim/scene/lattice_noise.h"

namespace touchdown::sim {
namespace {

constexpr double kSpeckCell_m = 0.06;

/// 1 within a joint of the given half width, 0 outside, with an edge about one texel wide.
double Joint(double distance_m, double half_width_m) {
  return std::clamp((half_width_m - distance_m) / 0.003 + 0.5, 0.0, 1.0);
}

}  // namespace

FloorPattern::FloorPattern(std::uint64_t seed) {
  models::RandomStream random(seed, "floor");
  kind_ = static_cast<Kind>(random.UniformInt(0, 3));
  seed_ = static_cast<std::uint32_t>(random.Bits());
  const double yaw = random.Uniform(-models::kPi, models::kPi);
  cos_yaw_ = std::cos(yaw);
  sin_yaw_ = std::sin(yaw);
  base_ = random.Uniform(70.0, 170.0);
  contrast_ = random.Uniform(0.7, 1.3);
  unit_m_ = random.Uniform(0.8, 1.3);
  specks_per_cell_ = random.Uniform(0.15, 0.6);
  const double warmth = kind_ == Kind::kPlanks ? random.Uniform(0.15, 0.3) : random.Uniform(-0.08, 0.1);
  green_ = 1.0 - warmth;
  blue_ = 1.0 - 2.0 * warmth;
}

double FloorPattern::At(const Eigen::Vector2d& p_W) const {
  const Eigen::Vector2d p(cos_yaw_ * p_W.x() + sin_yaw_ * p_W.y(), cos_yaw_ * p_W.y() - sin_yaw_ * p_W.x());
  double level = base_;
  switch (kind_) {
    case Kind::kConcrete:
      level += contrast_ * Concrete(p);
      break;
    case Kind::kPlanks:
      level += contrast_ * Planks(p);
      break;
    case Kind::kCarpet:
      level += contrast_ * Carpet(p);
      break;
    case Kind::kTiles:
      level += contrast_ * Tiles(p);
      break;
  }
  return std::clamp(level + Specks(p), 8.0, 245.0);
}

double FloorPattern::Concrete(const Eigen::Vector2d& p) const {
  const double clouds = FractalNoise(p.x() / 0.6, p.y() / 0.6, 3, seed_);
  const double grain = FractalNoise(p.x() / 0.018, p.y() / 0.018, 2, seed_ + 11);
  return 40.0 * clouds + 35.0 * grain;
}

double FloorPattern::Planks(const Eigen::Vector2d& p) const {
  const double width = 0.11 * unit_m_, length = 0.9 * unit_m_;
  const double row = std::floor(p.y() / width);
  const double along = p.x() / length + CellValue(row, 0, seed_);
  const double plank = std::floor(along);
  const double across_edge = std::min(p.y() - row * width, (row + 1) * width - p.y());
  const double along_edge = length * std::min(along - plank, plank + 1 - along);
  const double shade = 50.0 * (CellValue(row, plank, seed_ + 1) - 0.5);
  const double grain = FractalNoise(p.x() / 0.25 + 7.0 * row, p.y() / 0.012, 2, seed_ + 2);
  return shade + 42.0 * grain - 45.0 * Joint(std::min(across_edge, along_edge), 0.002);
}

double FloorPattern::Carpet(const Eigen::Vector2d& p) const {
  const double thread = 0.011 * unit_m_;
  const double weave = std::sin(2.0 * models::kPi * p.x() / thread) * std::sin(2.0 * models::kPi * p.y() / thread);
  const double fluff = SmoothNoise(p.x() / 0.007, p.y() / 0.007, seed_);
  const double motif = SmoothNoise(p.x() / (0.09 * unit_m_), p.y() / (0.09 * unit_m_), seed_ + 3);
  return 12.0 * weave + 28.0 * fluff + 38.0 * std::tanh(4.0 * motif);
}

double FloorPattern::Tiles(const Eigen::Vector2d& p) const {
  const double tile = 0.22 * unit_m_;
  const double column = std::floor(p.x() / tile), row = std::floor(p.y() / tile);
  const double to_edge =
      std::min({p.x() - column * tile, (column + 1) * tile - p.x(), p.y() - row * tile, (row + 1) * tile - p.y()});
  const double marble = FractalNoise(p.x() / 0.1 + 3.0 * column, p.y() / 0.1 + 5.0 * row, 3, seed_);
  const double shade = 40.0 * (CellValue(column, row, seed_ + 5) - 0.5);
  return std::lerp(shade + 40.0 * marble, -50.0, Joint(to_edge, 0.003));
}

double FloorPattern::Specks(const Eigen::Vector2d& p) const {
  const double column = std::floor(p.x() / kSpeckCell_m), row = std::floor(p.y() / kSpeckCell_m);
  if (CellValue(column, row, seed_ + 6) > specks_per_cell_) return 0.0;
  const double radius = kSpeckCell_m * (0.04 + 0.16 * CellValue(column, row, seed_ + 7));
  const double reach = kSpeckCell_m - 2.0 * radius;
  const double cx = column * kSpeckCell_m + radius + reach * CellValue(column, row, seed_ + 8);
  const double cy = row * kSpeckCell_m + radius + reach * CellValue(column, row, seed_ + 9);
  const double inside = radius - std::hypot(p.x() - cx, p.y() - cy);
  const double strength = 130.0 * (CellValue(column, row, seed_ + 10) - 0.6);
  return strength * std::clamp(inside / 0.003 + 0.5, 0.0, 1.0);
}

}  // namespace touchdown::sim
