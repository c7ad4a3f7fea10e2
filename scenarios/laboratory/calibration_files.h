#pragma once

#include <optional>
#include <string>

#include "scenarios/laboratory/calibration_bench.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::laboratory {

/// What was calibrated.
struct CalibrationRun {
  std::optional<runner::Scenario>
      scenario;  ///< Whose vehicle it was; nullopt for a real one, of which there is no truth.
  std::optional<ImuCalibration> imu;
  std::optional<CameraCalibration> camera;
};

/// What a scenario is to be told: Scenario::calibration.
runner::Calibration CalibrationOf(const CalibrationRun& run);

/// The text of calibration.json: what was found, what is true, and the difference.
std::string CalibrationJson(const CalibrationRun& run);

/// The same in some lines for people.
std::string CalibrationText(const CalibrationRun& run);

/// Every view with the corners that were found, on one picture, as PNG. Throws std::runtime_error when it cannot be
/// encoded.
std::string CalibrationViewsPng(const CameraCalibration& camera, const Chessboard& board);

}  // namespace touchdown::laboratory
