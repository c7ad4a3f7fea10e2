#pragma once

#include <opencv2/core.hpp>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Convolves with a disc.
void Defocus(cv::Mat1f& radiance, double radius_px);

/// Convolves with a line.
void SmearAlong(cv::Mat1f& radiance, double length_px, double angle);

/// Image of a radiance: vignette, exposure, gamma, noise, sharpening, JPEG compression.
cv::Mat1b Develop(cv::Mat1f radiance, double exposure, double noise_sigma, int jpeg_quality,
                  models::RandomStream& random);

}  // namespace touchdown::tests
