#include "sim/scene/shadow_mask.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace touchdown::sim {

void FillOutline(std::span<const Eigen::Vector2d> outline,
                 const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixel_of, std::uint8_t value,
                 cv::Mat1b& mask) {
  constexpr int kFractionBits = 6;
  std::vector<cv::Point> corners;
  for (const Eigen::Vector2d& p_W : outline) {
    const Eigen::Vector2d pixel = (1 << kFractionBits) * pixel_of(p_W);
    corners.emplace_back(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
  }
  cv::fillConvexPoly(mask, corners, cv::Scalar(value), cv::LINE_AA, kFractionBits);
}

}  // namespace touchdown::sim
