#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>

#include "models/signals.h"
#include "scenarios/laboratory/calibration_pattern.h"
#include "sim/sensors/camera.h"

namespace touchdown::laboratory {

/// Renders images of a chessboard with the lens and the noise of the flight's camera, at rest. The pinhole view is
/// oversampled and averaged over the camera's pixels, for accurate edges of solid shapes.
class ChessboardCamera {
 public:
  /// Throws InputError when the camera is invalid, and std::runtime_error when no GL context is available.
  ChessboardCamera(const Chessboard& board, const Eigen::Isometry3d& X_WE, const sim::CameraConfig& camera,
                   std::uint64_t seed);
  ~ChessboardCamera();
  ChessboardCamera(const ChessboardCamera&) = delete;
  ChessboardCamera& operator=(const ChessboardCamera&) = delete;

  models::Image Capture(const Eigen::Isometry3d& X_WC);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::laboratory
