#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace touchdown::tests {

/// Expects that an image has the size of docs/images/`name` and differs from it by at most `tolerance` of 255 on
/// average. If the environment has TOUCHDOWN_WRITE_DOCS, writes the file first.
void ExpectDocsImage(const std::string& name, const cv::Mat& drawn, double tolerance);

}  // namespace touchdown::tests
