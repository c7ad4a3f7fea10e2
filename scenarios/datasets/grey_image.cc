#include "scenarios/datasets/grey_image.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace touchdown::datasets {

models::Image ToGreyImage(const cv::Mat& picture) {
  cv::Mat grey = picture;
  if (picture.channels() > 1) {
    cv::cvtColor(picture, grey, picture.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  }
  constexpr double kFrom16Bit = 1.0 / 257.0;
  if (grey.depth() != CV_8U) grey.convertTo(grey, CV_8U, grey.depth() == CV_16U ? kFrom16Bit : 1.0);
  models::Image image(grey.cols, grey.rows);
  for (int v = 0; v < grey.rows; ++v) std::copy_n(grey.ptr(v), grey.cols, image.Row(v));
  return image;
}

}  // namespace touchdown::datasets
