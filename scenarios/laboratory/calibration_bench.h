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

/// What gravity tells of the IMU, and how wrong it is.
struct ImuCalibration {
  estimator::calibration::ImuMounting found;
  models::Mounting mounting;    ///< The same for Calibration::imu; its position is B's origin (Sec. III-D).
  double tilt_error_rad = 0.0;  ///< Between the vertical that it gives on level ground and the true one.
};

/// The IMU's mounting from samples at rest on level ground; what is true is not known, and so is no error. Throws
/// InputError as estimator::FindImuMounting does.
ImuCalibration ImuCalibrationFrom(std::span<const models::ImuSample> samples);

/// Puts the scenario's vehicle on level ground, as it truly is, for `rest_s`, and reads its IMU's mounting from the
/// samples (Sec. III-D). The turn-on bias is drawn anew, from the scenario's seed but not as its flight's is: between
/// calibration and flight the IMU was off. Throws InputError as estimator::FindImuMounting does.
ImuCalibration CalibrateImu(const runner::Scenario& scenario, double rest_s = 5.0);

/// How the camera is calibrated.
struct CameraCalibrationConfig {
  Chessboard board;
  int views = 27;       ///< Three times around the image.
  double rest_s = 1.0;  ///< How long vehicle and board are tracked for each view.
  LensTerms terms = LensTerms::kRadial;
};

/// A view of the board.
struct CalibrationPicture {
  models::Image image;
  std::optional<SeenCorners> corners;  ///< nullopt where the board was not found.
};

/// What views of a chessboard tell of the camera, and how wrong it is.
struct CameraCalibration {
  CameraFit fit;
  estimator::calibration::PoseMean X_BC;  ///< Eq. 2 over the views.
  models::Mounting mounting;              ///< The same for Calibration::camera.
  std::vector<CalibrationPicture> pictures;
  int views_used() const;
  double focal_error_px = 0.0;            ///< The larger one of fx and fy.
  double principal_point_error_px = 0.0;  ///< Distance.
  double position_error_m = 0.0;
  double rotation_error_rad = 0.0;
};

/// Told that a share of the work is done, in [0, 1]; may throw to stop.
using CalibrationObserver = std::function<void(double share)>;

/// Takes pictures of a chessboard with the scenario's camera from poses drawn from the scenario's seed, while the
/// tracking system follows vehicle and board, both at rest; fits the camera to them, and finds its mounting by Eq. 2.
/// The same scenario gives the same result. `observer` may be null. Throws InputError when the camera does not see the
/// board, or the tracking system neither.
CameraCalibration CalibrateCamera(const runner::Scenario& scenario, const CameraCalibrationConfig& config = {},
                                  const CalibrationObserver& observer = nullptr);

}  // namespace touchdown::laboratory
