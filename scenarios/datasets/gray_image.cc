#include "scenarios/datasets/gray_image.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace touchdown::datasets {

models::Image ToGrayImage(const cv::Mat& mat) {
  cv::Mat gray = mat;
  if (mat.channels() > 1) {
    cv::cvtColor(mat, gray, mat.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  }
  constexpr double kFrom16Bit = 1.0 / 257.0;
  if (gray.depth() != CV_8U) gray.convertTo(gray, CV_8U, gray.depth() == CV_16U ? kFrom16Bit : 1.0);
  models::Image image(gray.cols, gray.rows);
  for (int v = 0; v < gray.rows; ++v) std::copy_n(gray.ptr(v), gray.cols, image.Row(v));
  return image;
}

}  // namespace touchdown::datasets
