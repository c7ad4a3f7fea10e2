#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "estimator/calibration/imu_mounting.h"
#include "estimator/calibration/pose_mean.h"
#include "models/signals.h"
#include "models/vehicle.h"
#include "scenarios/laboratory/calibration_corners.h"
#include "scenarios/laboratory/calibration_pattern.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::laboratory {

/// Calibration of the IMU mounting from gravity.
struct ImuCalibration {
  estimator::calibration::ImuMounting estimate;
  models::Mounting mounting;    ///< Estimate for Calibration::imu, with its position at the origin of B (Sec. III-D).
  double tilt_error_rad = 0.0;  ///< Angle between the estimated vertical on level ground and the true one.
};

/// Estimates the IMU mounting from samples at rest on level ground. The true mounting is unknown, so tilt_error_rad
/// stays 0. Throws InputError as estimator::calibration::FindImuMounting does.
ImuCalibration ImuCalibrationFrom(std::span<const models::ImuSample> samples);

/// Simulates the scenario's vehicle at rest on level ground for `rest_s` seconds, and estimates the IMU mounting from
/// the samples (Sec. III-D). The turn-on bias differs from that of the flight, because the IMU is switched off between
/// calibration and flight; both derive from the seed of the scenario. Throws InputError as
/// estimator::calibration::FindImuMounting does.
ImuCalibration CalibrateImu(const runner::Scenario& scenario, double rest_s = 5.0);

/// Settings of the camera calibration.
struct CameraCalibrationConfig {
  Chessboard board;
  int views = 27;       ///< Number of views; 27 place the board three times at each of nine image positions.
  double rest_s = 1.0;  ///< Tracking time of vehicle and board for each view, s.
  LensTerms terms = LensTerms::kRadial;
};

/// A view of the board.
struct CalibrationView {
  models::Image image;
  std::optional<ImageCorners> corners;  ///< nullopt when the board was not detected.
};

/// Camera intrinsics and mounting estimated from views of a chessboard, and their errors.
struct CameraCalibration {
  CameraFit fit;
  estimator::calibration::PoseMean X_BC;  ///< Mean of Eq. 2 over the views.
  models::Mounting mounting;              ///< X_BC as a mounting, for Calibration::camera.
  std::vector<CalibrationView> views;
  int views_used() const;
  double focal_error_px = 0.0;            ///< Larger of the errors of fx and fy.
  double principal_point_error_px = 0.0;  ///< Euclidean distance.
  double position_error_m = 0.0;
  double rotation_error_rad = 0.0;
};

/// Called with the completed fraction of the work, 0 to 1; may throw to stop.
using CalibrationProgress = std::function<void(double fraction)>;

/// Calibrates the scenario's camera with a simulated chessboard. Camera poses are drawn from the seed of the scenario.
/// The tracking system measures vehicle and board at rest for each view. Fits the intrinsics to the corners, and
/// computes the mounting with Eq. 2. The same scenario gives the same result. `progress` may be null. Throws InputError
/// when the camera does not see the board or when the tracking system gives no poses.
CameraCalibration CalibrateCamera(const runner::Scenario& scenario, const CameraCalibrationConfig& config = {},
                                  const CalibrationProgress& progress = nullptr);

}  // namespace touchdown::laboratory
