#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown calibrate imu|camera|all SCENARIO --out DIR`: the calibrations of Sec. III-D, on the scenario's vehicle;
/// `touchdown calibrate imu --imu FILE --out DIR` from a real one's samples.
AddCommand AddCalibrate;

}  // namespace touchdown::cli
