#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown estimate INPUT [--camera CAMERA.yaml] [--pad PAD.yaml] [--imu FILE] [--vehicle VEHICLE.yaml]
/// [--estimator NAME] [--video] --out DIR`: the estimator alone, on footage.
AddCommand AddEstimate;

}  // namespace touchdown::cli
