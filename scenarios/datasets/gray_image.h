#pragma once

#include <opencv2/core/mat.hpp>

#include "models/signals.h"

namespace touchdown::datasets {

/// A picture of 1, 3 or 4 channels of 8 or 16 bit, as OpenCV orders them, in gray of 8 bit.
models::Image ToGrayImage(const cv::Mat& picture);

}  // namespace touchdown::datasets
