#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "models/signals.h"

namespace touchdown::sim {

/// A frame before noise is added: gray levels in units of 1/256, row by row.
struct FineImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> pixels;
};

/// A gray image laid out for fast bilinear lookups: each word holds a pixel and its three neighbors to the right and
/// below. All arithmetic uses integers, so that sums do not depend on the CPU's instruction set.
class PackedImage {
 public:
  static constexpr int kFractionBits = 16;  ///< Fixed-point positions have a resolution of 1/65536 px.

  /// A run of lookups: position i is (x[i], y[i]) + shift + i * step. Positions beyond the image are clamped to its
  /// border.
  struct Run {
    const std::int32_t* x = nullptr;
    const std::int32_t* y = nullptr;
    int count = 0;
    Eigen::Matrix<std::int32_t, 2, 1> shift = {0, 0};
    Eigen::Matrix<std::int32_t, 2, 1> step = {0, 0};
  };

  PackedImage() = default;
  explicit PackedImage(const models::Image& image) { Pack(image); }

  /// Replaces the packed image. The image has at least 2 x 2 px.
  void Pack(const models::Image& image);

  /// Adds the gray levels of a run, interpolated at 1/256 px, to sums[0] to sums[count - 1], in 1/65536 gray level.
  void AddLookups(const Run& run, std::uint32_t* sums) const;

 private:
  std::int32_t stride_ = 0;
  std::int32_t x_limit_ = 0;
  std::int32_t y_limit_ = 0;
  std::vector<std::uint32_t> words_;
};

/// Divides each sum of `taps` lookups (at most 32) by `taps`: levels[i] is their mean in 1/256 gray level.
void WriteMeans(std::span<const std::uint32_t> sums, int taps, std::uint16_t* levels);

}  // namespace touchdown::sim
