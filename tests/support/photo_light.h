#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "models/random_stream.h"

namespace touchdown::tests {

/// 1 at `center`, falling as a bell whose axes, turned by `angle`, have these radii.
cv::Mat1f Bell(cv::Size size, const Eigen::Vector2d& center, double radius_u, double radius_v, double angle);

/// Light that falls on a scene, about 1: a slope, a lamp, and where `shadow` is below 1 the shadow of something with an
/// edge across the ring, which leaves this share of the light.
cv::Mat1f DrawLight(cv::Size size, const cv::Rect2d& ring_box, double shadow, models::RandomStream& random);

/// The lamp's mirror image on toner and, weaker, on paper, `strength` bright; nothing where that is 0.
void AddGlare(double strength, const cv::Rect2d& ring_box, const cv::Mat1f& toner, models::RandomStream& random,
              cv::Mat1f& radiance);

}  // namespace touchdown::tests
