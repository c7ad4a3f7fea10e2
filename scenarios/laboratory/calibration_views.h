#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "scenarios/laboratory/calibration_pattern.h"

namespace touchdown::laboratory {

/// Draws camera poses X_EC from which the whole board is visible. The board cycles through nine image positions:
/// center, edges and corners. Its distance is 1 to 1.25 times the smallest one at which it fits in the image. Its tilt
/// to the line of sight is up to 45 degrees about any axis, and its rotation about the line of sight is arbitrary.
/// Throws InputError when no such pose is found.
std::vector<Eigen::Isometry3d> DrawCalibrationViews(const Chessboard& board, const models::CameraModel& camera,
                                                    int count, models::RandomStream& random);

}  // namespace touchdown::laboratory
