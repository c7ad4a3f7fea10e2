#pragma once

#include <memory>

#include "models/signals.h"

namespace touchdown::experiments {

/// AprilTag 3 detector (Krogius, Haggenmiller, Olson 2019) with its default settings, on one thread. It is the
/// reference for the computation time per frame.
class AprilTagDetector {
 public:
  /// `decimate` is the factor by which the image is downsampled before the search for quads.
  explicit AprilTagDetector(float decimate = 1.0F);
  ~AprilTagDetector();
  AprilTagDetector(const AprilTagDetector&) = delete;
  AprilTagDetector& operator=(const AprilTagDetector&) = delete;

  /// Number of tags of the family 36h11 detected in the image.
  int Detect(const models::ImageView& image);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::experiments
