#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Gaussian with the value 1 at `center`. Its axes are rotated by `angle` and have these standard deviations.
cv::Mat1f GaussianSpot(cv::Size size, const Eigen::Vector2d& center, double radius_u, double radius_v, double angle);

/// Draws the illumination of a scene, relative to a nominal value: a gradient, sometimes a lamp, and if `shadow` is
/// below 1 a shadow with an edge across the ring. `shadow` is the fraction of the light inside the shadow.
cv::Mat1f DrawLight(cv::Size size, const cv::Rect2d& ring_box, double shadow, models::RandomStream& random);

/// Adds the reflection of a lamp on toner and, weaker, on paper, with brightness `strength`; nothing if it is 0.
void AddGlare(double strength, const cv::Rect2d& ring_box, const cv::Mat1f& toner, models::RandomStream& random,
              cv::Mat1f& radiance);

}  // namespace touchdown::tests
