#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace touchdown::tests {

/// Compares an image with docs/images/`name`: the same size, and on average at most `tolerance` of 255 apart.
/// With TOUCHDOWN_WRITE_DOCS in the environment it makes the picture first.
void ExpectPicture(const std::string& name, const cv::Mat& drawn, double tolerance);

}  // namespace touchdown::tests
