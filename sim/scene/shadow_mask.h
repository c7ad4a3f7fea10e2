#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <span>

namespace touchdown::sim {

/// Fills a convex outline in `mask` with `value`. `pixel_of` maps a point on the ground to the mask, whose pixel
/// centers lie on integer coordinates.
void FillOutline(std::span<const Eigen::Vector2d> outline,
                 const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixel_of, std::uint8_t value,
                 cv::Mat1b& mask);

}  // namespace touchdown::sim
