#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace touchdown::sim {

/// A floor as a function of position: concrete, planks, carpet or tiles, with specks, drawn from a seed. It is defined
/// everywhere, so that textures of different resolution show the same floor.
class FloorPattern {
 public:
  explicit FloorPattern(std::uint64_t seed);

  /// Reflectance, 0 to 255, at a point of the floor in W.
  double At(const Eigen::Vector2d& p_W) const;

  /// Ratios of green and blue to red.
  double green() const { return green_; }
  double blue() const { return blue_; }

 private:
  enum class Kind { kConcrete, kPlanks, kCarpet, kTiles };

  double Concrete(const Eigen::Vector2d& p) const;
  double Planks(const Eigen::Vector2d& p) const;
  double Carpet(const Eigen::Vector2d& p) const;
  double Tiles(const Eigen::Vector2d& p) const;
  double Specks(const Eigen::Vector2d& p) const;

  Kind kind_;
  std::uint32_t seed_;
  double cos_yaw_, sin_yaw_;
  double base_;
  double contrast_;
  double unit_m_;
  double specks_per_cell_;
  double green_, blue_;
};

}  // namespace touchdown::sim
