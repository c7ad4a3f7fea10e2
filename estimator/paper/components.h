#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Contiguous dark pixels of row `v`, columns [u_begin, u_end).
struct Run {
  int v = 0;
  int u_begin = 0;
  int u_end = 0;

  friend bool operator==(const Run&, const Run&) = default;
};

/// 8-connected component of dark pixels.
struct Component {
  int u = 0, v = 0, width = 0, height = 0;   ///< Bounding box, px.
  int area = 0;                              ///< Number of pixels.
  std::size_t first_run = 0, run_count = 0;  ///< Range of ComponentSet::runs.
};

/// Components of an image in the order of their first pixel, and their runs. The runs of a component are contiguous and
/// in raster order.
struct ComponentSet {
  int image_width = 0, image_height = 0;
  std::vector<Run> runs;
  std::vector<Component> components;

  /// The runs of a component of this set.
  std::span<const Run> RunsOf(const Component& component) const {
    return std::span(runs).subspan(component.first_run, component.run_count);
  }

  /// Whether the component touches the image border, so that part of the object may be outside the image.
  bool IsCutByBorder(const Component& c) const {
    return c.u <= 0 || c.v <= 0 || c.u + c.width >= image_width || c.v + c.height >= image_height;
  }
};

/// Smallest components that are classified (Sec. IV-A.2). Larger values save time and reduce the height up to which the
/// pad is detected: the bounding box of the H is 21 x 12 px at 1.5 m and 11 x 6 px at 3 m.
struct ComponentsConfig {
  int min_long_side_px = 9;
  int min_short_side_px = 4;
  int min_area_px = 24;

  /// Throws InputError when a value is not positive.
  void Validate() const;
};

/// Extracts the 8-connected components of the nonzero pixels of `dark` that are not too small, by run-based two-scan
/// labeling (He, Chao, Suzuki: A run-based two-scan labeling algorithm, IEEE Trans. Image Processing 17(5), 2008).
ComponentSet ExtractComponents(const models::ImageView& dark, const ComponentsConfig& config = {});

}  // namespace touchdown::estimator::paper
