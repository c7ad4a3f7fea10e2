#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace touchdown::sim {

/// Fraction of the light that reaches a square of the ground, aligned with W.
struct GroundShade {
  cv::Mat1b
      light;  ///< 255: all of it, as at the border everywhere. Row 0 lies at the highest y, column 0 at the lowest x.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double side_m = 0.0;
};

/// Darkens the ground in an image that OpenGL has drawn; needs its context, matrices and depths.
class GroundShadePainter {
 public:
  /// Objects in front of the ground hide the shade.
  void Paint(const GroundShade& shade);

 private:
  void Upload(const cv::Mat1b& light);

  std::uint32_t texture_ = 0;  ///< Released with its context.
};

}  // namespace touchdown::sim
