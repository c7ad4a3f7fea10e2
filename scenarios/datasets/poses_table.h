#pragma once

#include <span>
#include <string>

#include "models/time.h"
#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/runner/tum_trajectory.h"

namespace touchdown::datasets {

/// CSV table with one row per frame; cells without a value are empty. The pose is X_WB, or X_WC without a mounting, for
/// each frame with a pose. Pixels are raw. The ellipse is the outer edge of the ring: semi-axes in undistorted pixels,
/// and angle from +u towards +v. The box is the bounding box of the ring.
std::string PosesCsv(std::span<const FootageEstimate> estimates, const models::TimeBase& time);

/// CSV table with one row per choice between the two pose hypotheses: the reason and the measures of both.
std::string ChoicesCsv(std::span<const FootageEstimate> estimates);

/// Poses of all frames with status ok. A frame without a time has its index, counted from 0, as its time in seconds.
runner::Trajectory PosesTrajectory(std::span<const FootageEstimate> estimates, const models::TimeBase& time);

}  // namespace touchdown::datasets
