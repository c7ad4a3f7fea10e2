#include "sim/render/packed_image.h"

#include <algorithm>
#include <cstddef>

#include "sim/render/cpu_clones.h"

namespace touchdown::sim {
namespace {

TOUCHDOWN_CLONE_FOR_CPUS
void PackRow(const std::uint8_t* upper, const std::uint8_t* lower, std::int32_t count, std::uint32_t* words) {
  for (std::int32_t u = 0; u < count; ++u) {
    words[u] = static_cast<std::uint32_t>(upper[u]) | static_cast<std::uint32_t>(upper[u + 1]) << 8 |
               static_cast<std::uint32_t>(lower[u]) << 16 | static_cast<std::uint32_t>(lower[u + 1]) << 24;
  }
}

/// Weights two bytes of a packed word at once, each in its own half of a 32-bit word.
TOUCHDOWN_CLONE_FOR_CPUS
void Add(const std::uint32_t* __restrict words, std::int32_t stride, std::int32_t x_limit, std::int32_t y_limit,
         const std::int32_t* __restrict xs, const std::int32_t* __restrict ys, std::int32_t count, std::int32_t shift_x,
         std::int32_t shift_y, std::int32_t step_x, std::int32_t step_y, std::uint32_t* __restrict sums) {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t x = std::min(std::max(xs[i] + shift_x + i * step_x, 0), x_limit);
    const std::int32_t y = std::min(std::max(ys[i] + shift_y + i * step_y, 0), y_limit);
    const std::uint32_t word = words[(y >> PackedImage::kFractionBits) * stride + (x >> PackedImage::kFractionBits)];
    const std::uint32_t right = (static_cast<std::uint32_t>(x) >> 8) & 255u;
    const std::uint32_t low = (static_cast<std::uint32_t>(y) >> 8) & 255u;
    const std::uint32_t rows = (word & 0x00FF00FFu) * (256u - right) + ((word >> 8) & 0x00FF00FFu) * right;
    sums[i] += (rows & 0xFFFFu) * (256u - low) + (rows >> 16) * low;
  }
}

TOUCHDOWN_CLONE_FOR_CPUS
void Scale(const std::uint32_t* __restrict sums, std::size_t count, float factor, std::uint16_t* __restrict levels) {
  for (std::size_t i = 0; i < count; ++i) {
    const float level = static_cast<float>(static_cast<std::int32_t>(sums[i])) * factor;  // At least 0.
    levels[i] = static_cast<std::uint16_t>(static_cast<std::int32_t>(level + 0.5f));      // NOLINT: vectorized.
  }
}

}  // namespace

void PackedImage::Pack(const models::Image& image) {
  stride_ = image.width;
  x_limit_ = ((image.width - 1) << kFractionBits) - 1;
  y_limit_ = ((image.height - 1) << kFractionBits) - 1;
  words_.resize(image.pixels.size());
  for (int v = 0; v + 1 < image.height; ++v) {
    const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(v) * image.width;
    const std::uint8_t* upper = image.pixels.data() + begin;
    PackRow(upper, upper + image.width, image.width - 1, words_.data() + begin);
  }
}

void PackedImage::AddLookups(const Run& run, std::uint32_t* sums) const {
  Add(words_.data(), stride_, x_limit_, y_limit_, run.x, run.y, run.count, run.shift.x(), run.shift.y(), run.step.x(),
      run.step.y(), sums);
}

void WriteMeans(std::span<const std::uint32_t> sums, int taps, std::uint16_t* levels) {
  Scale(sums.data(), sums.size(), 1.0f / static_cast<float>(256 * taps), levels);
}

}  // namespace touchdown::sim
