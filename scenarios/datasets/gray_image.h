#pragma once

#include <opencv2/core/mat.hpp>

#include "models/signals.h"

namespace touchdown::datasets {

/// Converts an image with 1, 3 or 4 channels (gray, BGR or BGRA) of 8 or 16 bits to 8-bit gray.
models::Image ToGrayImage(const cv::Mat& mat);

}  // namespace touchdown::datasets
