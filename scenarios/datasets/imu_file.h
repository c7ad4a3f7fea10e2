#pragma once

#include <filesystem>
#include <vector>

#include "models/time.h"
#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// The samples of an IMU from a file of EuRoC's layout: time in ns, then the angular rate about x, y, z in rad/s and
/// the specific force along x, y, z in m/s^2, in the IMU's frame. A file at_rest.csv beside it, where there is one,
/// tells from which times on the vehicle knew that it stood on the ground (1) or not (0). Throws InputError as
/// ReadStampedCsv does.
std::vector<ImuReading> ReadImuFile(const std::filesystem::path& file, const models::TimeBase& time);

}  // namespace touchdown::datasets
