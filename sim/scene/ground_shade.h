#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace touchdown::sim {

/// How much of its light a square of the ground keeps, along W's axes.
struct GroundShade {
  cv::Mat1b
      light;  ///< 255: all of it, as at the border everywhere. Row 0 lies at the highest y, column 0 at the lowest x.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double side_m = 0.0;
};

/// Darkens the ground in a picture that OpenGL has drawn, as long as its context, matrices and depths are still there.
class GroundShadePainter {
 public:
  /// What stands before the ground hides the shade.
  void Paint(const GroundShade& shade);

 private:
  void Upload(const cv::Mat1b& light);

  std::uint32_t texture_ = 0;  ///< Goes with its context.
};

}  // namespace touchdown::sim
