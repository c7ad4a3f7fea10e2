#pragma once

#include <memory>

#include "models/signals.h"

namespace touchdown::experiments {

/// AprilTag 3 (Krogius, Haggenmiller, Olson 2019) as it comes, on one thread: the yardstick for what looking
/// at a frame costs.
class AprilTagDetector {
 public:
  /// `decimate`: it looks for tags in an image so many times smaller.
  explicit AprilTagDetector(float decimate = 1.0F);
  ~AprilTagDetector();
  AprilTagDetector(const AprilTagDetector&) = delete;
  AprilTagDetector& operator=(const AprilTagDetector&) = delete;

  /// How many tags of the family 36h11 the image shows.
  int Detect(const models::ImageView& image);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::experiments
