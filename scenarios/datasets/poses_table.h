#pragma once

#include <span>
#include <string>

#include "models/time.h"
#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/runner/tum_trajectory.h"

namespace touchdown::datasets {

/// One row for each frame; a cell is empty where there is nothing to tell. The pose is that of every frame that has
/// one, X_WB or, without a mounting, X_WC; pixels are raw, the ellipse is the ring's outer one, its center left out,
/// with semi-axes in undistorted pixels and its angle from +u towards +v; the box encloses the ring.
std::string PosesCsv(std::span<const FootageEstimate> estimates, const models::TimeBase& time);

/// One row for each frame with a pose: which of the two poses of a circle was taken, and why.
std::string ChoicesCsv(std::span<const FootageEstimate> estimates);

/// The poses of frames with status ok; frames without a time stand at their number, from 0, in seconds.
runner::Trajectory PosesTrajectory(std::span<const FootageEstimate> estimates, const models::TimeBase& time);

}  // namespace touchdown::datasets
