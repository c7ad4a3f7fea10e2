#pragma once

namespace touchdown::sim {

/// An undistorted view with square pixels. Pixel centers lie on integer coordinates.
struct PinholeView {
  int width_px = 640;
  int height_px = 480;
  double focal_px = 320.0;
  double cx_px = 319.5;
  double cy_px = 239.5;

  friend bool operator==(const PinholeView&, const PinholeView&) = default;
};

}  // namespace touchdown::sim
