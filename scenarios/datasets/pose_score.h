#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scenarios/datasets/tum_file.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::datasets {

/// How good somebody's poses of a flight are.
struct PoseScore {
  runner::Metrics metrics;  ///< estimate.*
  std::size_t poses = 0;    ///< That were held against the truth.
  std::size_t outside = 0;  ///< That lie before, after or in a gap of the truth.
};

/// Holds poses of the body in W against the truth at their own times, as they are: nothing is aligned. Each counts as a
/// frame with status ok.
///
/// `truth` is a flight's folder or a recording of one. Of a flight's folder its frames count too: a frame is available
/// when a pose lies within half a frame's period of its mid-exposure, and a pose whose pad, seen by the flight's
/// camera as it was calibrated, is over 30 px from the true one is a false pad. A recording tells errors alone.
///
/// Throws InputError, naming file and line, for a folder that is neither, a damaged file, and poses none of which the
/// truth covers.
PoseScore ScorePoses(const std::vector<TimedPose>& poses, const std::filesystem::path& truth);

}  // namespace touchdown::datasets
