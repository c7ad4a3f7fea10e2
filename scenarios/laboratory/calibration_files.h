#pragma once

#include <optional>
#include <string>

#include "scenarios/laboratory/calibration_bench.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::laboratory {

/// Results of one run of the calibration.
struct CalibrationRun {
  /// Scenario of the simulated vehicle; nullopt for a real vehicle, which has no known truth.
  std::optional<runner::Scenario> scenario;
  std::optional<ImuCalibration> imu;
  std::optional<CameraCalibration> camera;
};

/// Calibration in the form of Scenario::calibration.
runner::Calibration CalibrationOf(const CalibrationRun& run);

/// Content of calibration.json: estimated values, true values and errors.
std::string CalibrationJson(const CalibrationRun& run);

/// Summary of the run in a few lines of text.
std::string CalibrationText(const CalibrationRun& run);

/// Contact sheet of all views with the detected corners, as PNG. Throws std::runtime_error when encoding fails.
std::string CalibrationViewsPng(const CameraCalibration& camera, const Chessboard& board);

}  // namespace touchdown::laboratory
