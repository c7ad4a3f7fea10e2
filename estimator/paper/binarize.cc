#include "estimator/paper/binarize.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

constexpr int kLargestWindow_px = 255;

/// Integral image: entry (u, v) is the sum over [0, u) x [0, v). Sums wrap around modulo 2^32. The wrap cancels in
/// differences, because the sum of a window is below 2^24.
class IntegralImage {
 public:
  explicit IntegralImage(const models::ImageView& image)
      : stride_(static_cast<std::size_t>(image.width) + 1),
        sums_(std::make_unique_for_overwrite<std::uint32_t[]>(stride_ * (static_cast<std::size_t>(image.height) + 1))) {
    std::fill_n(sums_.get(), stride_, 0u);
    for (int v = 0; v < image.height; ++v) {
      const std::uint8_t* pixels = image.Row(v);
      const std::uint32_t* above = Row(v);
      std::uint32_t* here = sums_.get() + stride_ * (static_cast<std::size_t>(v) + 1);
      std::uint32_t row_sum = here[0] = 0;
      for (int u = 0; u < image.width; ++u) {
        row_sum += pixels[u];
        here[u + 1] = above[u + 1] + row_sum;
      }
    }
  }

  const std::uint32_t* Row(int v) const { return sums_.get() + stride_ * static_cast<std::size_t>(v); }

 private:
  std::size_t stride_;
  std::unique_ptr<std::uint32_t[]> sums_;
};

/// The part [begin, end) of a window around a pixel that is inside the image, along one axis.
struct WindowSpan {
  WindowSpan(int center, int radius, int size)
      : begin(std::max(0, center - radius)), end(std::min(size, center + radius + 1)) {}
  int length() const { return end - begin; }
  int begin, end;
};

}  // namespace

void BinarizeConfig::Validate() const {
  if (window_px <= 0 || window_px % 2 == 0 || window_px > kLargestWindow_px) {
    throw InputError("window_px must be odd and 1 to 255");
  }
  if (!std::isfinite(relative_margin) || relative_margin < 0.0 || relative_margin >= 1.0) {
    throw InputError("relative_margin must be at least 0 and below 1");
  }
  if (!std::isfinite(absolute_margin) || absolute_margin < 0.0) {
    throw InputError("absolute_margin must be finite and not negative");
  }
}

models::Image Binarize(const models::ImageView& image, const BinarizeConfig& config) {
  const IntegralImage integral(image);
  const int radius = config.window_px / 2;
  const int width = image.width, height = image.height;
  const int inner_begin = std::min(radius, width), inner_end = std::max(inner_begin, width - radius);
  const auto absolute_margin = static_cast<float>(config.absolute_margin);
  models::Image dark(width, height);
  std::vector<std::uint32_t> window_sums(static_cast<std::size_t>(width));
  std::vector<float> scales(static_cast<std::size_t>(width));

  for (int v = 0, rows = 0; v < height; ++v) {
    const WindowSpan vertical(v, radius, height);
    if (rows != vertical.length()) {
      rows = vertical.length();
      for (int u = 0; u < width; ++u) {
        scales[u] = static_cast<float>((1.0 - config.relative_margin) / (WindowSpan(u, radius, width).length() * rows));
      }
    }
    const std::uint32_t* above = integral.Row(vertical.begin);
    const std::uint32_t* below = integral.Row(vertical.end);
    const auto window_sum = [above, below](int left, int right) {
      return below[right] - below[left] - (above[right] - above[left]);
    };
    const auto border_sum = [&](int u) {
      const WindowSpan horizontal(u, radius, width);
      window_sums[u] = window_sum(horizontal.begin, horizontal.end);
    };
    for (int u = 0; u < inner_begin; ++u) border_sum(u);
    for (int u = inner_begin; u < inner_end; ++u) window_sums[u] = window_sum(u - radius, u + radius + 1);
    for (int u = inner_end; u < width; ++u) border_sum(u);

    const std::uint8_t* pixels = image.Row(v);
    std::uint8_t* row = dark.Row(v);
    for (int u = 0; u < width; ++u) {
      const float limit = static_cast<float>(static_cast<std::int32_t>(window_sums[u])) * scales[u];
      row[u] = static_cast<float>(pixels[u]) < limit - absolute_margin ? 255 : 0;
    }
  }
  return dark;
}

}  // namespace touchdown::estimator::paper
