#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "scenarios/laboratory/calibration_pattern.h"

namespace touchdown::laboratory {

/// Poses X_EC from which a camera sees the whole board, one after the other with the board at the image's center, edges
/// and corners, as near as it fits or up to a quarter farther, tilted against the line of sight by up to 45
/// degrees about any axis, and turned anyhow. Throws InputError when the camera's lens does not show the board whole
/// from anywhere.
std::vector<Eigen::Isometry3d> DrawCalibrationViews(const Chessboard& board, const models::CameraModel& camera,
                                                    int count, models::RandomStream& random);

}  // namespace touchdown::laboratory
