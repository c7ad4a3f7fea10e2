#pragma once

#include "estimator/frame_result.h"
#include "tests/support/photographed_pad.h"

namespace touchdown::tests {

/// Result of the estimator `paper` for a photograph, compared with the truth.
struct PhotoScore {
  estimator::FrameResult estimate;
  bool reports_pad = false;     ///< The estimator reported a pad.
  bool found = false;           ///< There is a pose, and center and ring box are right.
  double distance_error = 0.0;  ///< Relative error of the distance to the pad, if there is a pose.
};

/// Runs a new estimator on the photograph, with known gravity.
PhotoScore Score(const Photograph& photo);

}  // namespace touchdown::tests
