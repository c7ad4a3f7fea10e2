#pragma once

#include "estimator/frame_result.h"
#include "tests/support/photographed_pad.h"

namespace touchdown::tests {

/// What the estimator `paper` made of a photograph.
struct PhotoScore {
  estimator::FrameResult estimate;
  bool reports_pad = false;     ///< The estimator reported a pad.
  bool found = false;           ///< A pose, and center and ring box are those of the pad.
  double distance_error = 0.0;  ///< Of the camera from the pad, over the true distance; where there is a pose.
};

/// A fresh estimator on the single photograph, with gravity known and no earlier pose for comparison.
PhotoScore Score(const Photograph& photo);

}  // namespace touchdown::tests
