#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scenarios/datasets/tum_file.h"
#include "scenarios/runner/metrics.h"

namespace touchdown::datasets {

/// Errors of the poses of any estimator with respect to the truth of a flight.
struct PoseScore {
  runner::Metrics metrics;  ///< estimate.*
  std::size_t poses = 0;    ///< Number of poses compared with the truth.
  std::size_t outside = 0;  ///< Number of poses ignored: before, after or in a gap of the truth.
};

/// Compares poses X_WB with the truth at their times, without alignment. Each pose counts as a frame with status ok.
///
/// `truth` is a flight directory or a recording of a flight. A flight directory also gives detection metrics: a frame
/// is available when a pose is within half a frame period of its mid-exposure; a pose is a false pad when the pad
/// center, projected with the assumed camera model and mounting, is more than 30 px from the true one. A recording
/// gives only errors.
///
/// Throws InputError, naming file and line, for a directory that is neither, for an invalid file, and when the truth
/// covers none of the poses.
PoseScore ScorePoses(const std::vector<TimedPose>& poses, const std::filesystem::path& truth);

}  // namespace touchdown::datasets
