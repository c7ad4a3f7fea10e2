#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>

#include "models/signals.h"
#include "scenarios/laboratory/calibration_pattern.h"
#include "sim/sensors/camera.h"

namespace touchdown::laboratory {

/// Takes pictures of a chessboard as the flight's camera would, at rest: its lens, its noise. The pinhole view is
/// rendered finer than the camera's pixels and averaged over them, as edges of solid shapes need it.
class ChessboardCamera {
 public:
  /// Throws InputError when the camera is not valid, std::runtime_error when there is no GL context for it.
  ChessboardCamera(const Chessboard& board, const Eigen::Isometry3d& X_WE, const sim::CameraConfig& camera,
                   std::uint64_t seed);
  ~ChessboardCamera();
  ChessboardCamera(const ChessboardCamera&) = delete;
  ChessboardCamera& operator=(const ChessboardCamera&) = delete;

  models::Image Take(const Eigen::Isometry3d& X_WC);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::laboratory
