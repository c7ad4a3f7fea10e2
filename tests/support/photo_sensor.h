#pragma once

#include <opencv2/core.hpp>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Convolves the image with a disc of radius `radius_px`. Does nothing below 0.3 px.
void Defocus(cv::Mat1f& radiance, double radius_px);

/// Convolves the image with a line of length `length_px` at `angle`. Does nothing below 0.5 px.
void SmearAlong(cv::Mat1f& radiance, double length_px, double angle);

/// Computes the image from the radiance: vignette, exposure, gamma, noise, sharpening, JPEG compression.
cv::Mat1b Develop(cv::Mat1f radiance, double exposure, double noise_sigma, int jpeg_quality,
                  models::RandomStream& random);

}  // namespace touchdown::tests
