#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace touchdown::sim {

/// Fraction of the light that reaches a square of the ground, aligned with W.
struct GroundShade {
  /// 255 is full light, which the whole border has. Row 0 is at the highest y, column 0 at the lowest x.
  cv::Mat1b light;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double side_m = 0.0;
};

/// Darkens the ground in an image that OpenGL has drawn. The context, matrices and depth buffer of that image must be
/// current.
class GroundShadePainter {
 public:
  /// Objects in front of the ground hide the shade.
  void Paint(const GroundShade& shade);

 private:
  void Upload(const cv::Mat1b& light);

  std::uint32_t texture_ = 0;  ///< Released with its context.
};

}  // namespace touchdown::sim
