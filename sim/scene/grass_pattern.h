#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "models/landing_pad.h"

namespace touchdown::sim {

/// A meadow, drawn from a seed: grass in patches of several scales, with individual blades where the texels are fine
/// enough, and a path of gravel or stone slabs that runs past the pad's sheet.
class GrassPattern {
 public:
  GrassPattern(std::uint64_t seed, const models::LandingPad& pad);

  /// RGB reflectance, 0 to 255, of a square of side `side_m` around W's origin. Row 0 is at its +Y edge.
  cv::Mat3b Paint(double side_m, int texels) const;

  /// Whether a point of the ground is on the path.
  bool IsPath(const Eigen::Vector2d& p_W) const;

 private:
  enum class Path { kGravel, kSlabs };

  Eigen::Vector2d AlongAndAcross(const Eigen::Vector2d& p_W) const;
  Eigen::Vector3d Turf(const Eigen::Vector2d& p_W) const;
  cv::Mat3b PaintTurf(double side_m, int texels) const;
  double Lean(const Eigen::Vector2d& p, double deviation) const;
  void GrowBlades(double side_m, cv::Mat3b& texture) const;
  void LayPath(double side_m, cv::Mat3b& texture) const;
  double Gravel(const Eigen::Vector2d& p) const;
  double Slab(const Eigen::Vector2d& p) const;

  std::uint32_t seed_;
  Eigen::Vector3d green_;  ///< Mean reflectance of the grass.
  Path path_;
  double path_gray_;
  Eigen::Vector2d path_along_, path_left_;
  double path_distance_m_;  ///< Distance of the path's center line from the pad's center.
  double path_half_width_m_;
  double stone_m_;  ///< Size of the gravel's stones.
};

}  // namespace touchdown::sim
