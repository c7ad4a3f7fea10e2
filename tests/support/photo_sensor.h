#pragma once

#include <opencv2/core.hpp>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Blurs by a disc.
void Defocus(cv::Mat1f& radiance, double radius_px);

/// Blurs by a line.
void SmearAlong(cv::Mat1f& radiance, double length_px, double angle);

/// What a camera makes of the radiance that reaches its sensor: vignette, exposure, noise, gamma, sharpening, JPEG.
cv::Mat1b Develop(cv::Mat1f radiance, double exposure, double noise_sigma, int jpeg_quality,
                  models::RandomStream& random);

}  // namespace touchdown::tests
