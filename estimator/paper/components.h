#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Dark pixels side by side in row `v`, columns [u_begin, u_end).
struct Run {
  int v = 0;
  int u_begin = 0;
  int u_end = 0;

  friend bool operator==(const Run&, const Run&) = default;
};

/// Dark pixels that hang together by sides or corners.
struct Component {
  int u = 0, v = 0, width = 0, height = 0;  ///< Bounding box, px.
  int area = 0;                             ///< Pixels.
  std::size_t first_run = 0, run_count = 0;
};

/// The components of an image, in the order of their first pixel, and all their runs: those of one component lie
/// together, in raster order.
struct ComponentSet {
  int image_width = 0, image_height = 0;
  std::vector<Run> runs;
  std::vector<Component> components;

  std::span<const Run> RunsOf(const Component& component) const {
    return std::span(runs).subspan(component.first_run, component.run_count);
  }

  /// Whether the component touches the image's border, so that part of what it shows may lie outside.
  bool IsCutByBorder(const Component& c) const {
    return c.u <= 0 || c.v <= 0 || c.u + c.width >= image_width || c.v + c.height >= image_height;
  }
};

/// What is too small to be classified (Sec. IV-A.2). Larger values save time and lose the pad sooner with height: the
/// H's box is 21 x 12 px at 1.5 m and 11 x 6 px at 3 m.
struct ComponentsConfig {
  int smallest_long_side_px = 9;
  int smallest_short_side_px = 4;
  int smallest_area_px = 24;

  /// Throws InputError when a size is not positive.
  void Validate() const;
};

/// The 8-connected components of the pixels of `dark` that are not 0, without those too small. Run-based two-scan
/// labeling (He, Chao, Suzuki: A run-based two-scan labeling algorithm, IEEE Trans. Image Processing 17(5), 2008).
ComponentSet ExtractComponents(const models::ImageView& dark, const ComponentsConfig& config = {});

}  // namespace touchdown::estimator::paper
