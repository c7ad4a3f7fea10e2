#include "estimator/paper/binarize.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/error.h"

namespace touchdown::estimator {
namespace {

constexpr int kLargestWindow_px = 255;

/// Sums over the rectangle from the image's origin: entry (u, v) covers [0, u) x [0, v). Sums wrap around modulo 2^32,
/// which cancels in differences, since a window's own sum is below 2^24.
class IntegralImage {
 public:
  explicit IntegralImage(const models::ImageView& image)
      : stride_(static_cast<std::size_t>(image.width) + 1),
        sums_(stride_ * (static_cast<std::size_t>(image.height) + 1)) {
    for (int v = 0; v < image.height; ++v) {
      const std::uint8_t* pixels = image.Row(v);
      const std::uint32_t* above = Row(v) + 1;
      std::uint32_t* here = sums_.data() + stride_ * (static_cast<std::size_t>(v) + 1) + 1;
      std::uint32_t row_sum = 0;
      for (int u = 0; u < image.width; ++u) {
        row_sum += pixels[u];
        here[u] = above[u] + row_sum;
      }
    }
  }

  const std::uint32_t* Row(int v) const { return sums_.data() + stride_ * static_cast<std::size_t>(v); }

 private:
  std::size_t stride_;
  std::vector<std::uint32_t> sums_;
};

struct Threshold {
  float scale, offset;
};

/// Columns [u_begin, u_end), whose windows all lie `left` and `right` of the column.
void BinarizeInnerColumns(const std::uint8_t* pixels, const std::uint32_t* column_sums, int u_begin, int u_end,
                          int radius, const Threshold& threshold, std::uint8_t* dark) {
  for (int u = u_begin; u < u_end; ++u) {
    const std::uint32_t sum = column_sums[u + radius + 1] - column_sums[u - radius];
    const float limit = static_cast<float>(static_cast<std::int32_t>(sum)) * threshold.scale;
    dark[u] = static_cast<float>(pixels[u]) < limit - threshold.offset ? 255 : 0;
  }
}

}  // namespace

void BinarizeConfig::Validate() const {
  if (window_px <= 0 || window_px % 2 == 0 || window_px > kLargestWindow_px) {
    throw InputError("the threshold's window must be odd and 1 to 255 px wide");
  }
  if (!std::isfinite(relative_margin) || relative_margin < 0.0 || relative_margin >= 1.0) {
    throw InputError("the threshold's relative margin must be in [0, 1)");
  }
  if (!std::isfinite(absolute_margin) || absolute_margin < 0.0) {
    throw InputError("the threshold's absolute margin must be finite and not negative");
  }
}

models::Image Binarize(const models::ImageView& image, const BinarizeConfig& config) {
  const IntegralImage integral(image);
  const int radius = config.window_px / 2;
  const int width = image.width, height = image.height;
  const int inner_begin = std::min(radius, width), inner_end = std::max(inner_begin, width - radius);
  models::Image dark(width, height);
  std::vector<std::uint32_t> column_sums(static_cast<std::size_t>(width) + 1);

  for (int v = 0; v < height; ++v) {
    const int top = std::max(0, v - radius), bottom = std::min(height, v + radius + 1);
    const std::uint32_t* above = integral.Row(top);
    const std::uint32_t* below = integral.Row(bottom);
    for (int u = 0; u <= width; ++u) column_sums[static_cast<std::size_t>(u)] = below[u] - above[u];

    const auto offset = static_cast<float>(config.absolute_margin);
    const auto threshold_over = [&](int columns) {
      return Threshold{static_cast<float>((1.0 - config.relative_margin) / (columns * (bottom - top))), offset};
    };
    const auto border_column = [&](int u) {
      const int left = std::max(0, u - radius), right = std::min(width, u + radius + 1);
      const auto sum = static_cast<std::int32_t>(column_sums[static_cast<std::size_t>(right)] -
                                                 column_sums[static_cast<std::size_t>(left)]);
      const Threshold threshold = threshold_over(right - left);
      const float limit = static_cast<float>(sum) * threshold.scale - threshold.offset;
      dark.Row(v)[u] = static_cast<float>(image.At(u, v)) < limit ? 255 : 0;
    };
    for (int u = 0; u < inner_begin; ++u) border_column(u);
    BinarizeInnerColumns(image.Row(v), column_sums.data(), inner_begin, inner_end, radius,
                         threshold_over(config.window_px), dark.Row(v));
    for (int u = inner_end; u < width; ++u) border_column(u);
  }
  return dark;
}

}  // namespace touchdown::estimator
