#pragma once

#include <filesystem>
#include <vector>

#include "models/time.h"
#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// Reads IMU samples from a CSV file in the EuRoC layout: time in ns, angular rate about x, y, z in rad/s, and specific
/// force along x, y, z in m/s^2, both in the IMU frame U. An optional file at_rest.csv in the same directory contains
/// the times in ns at which the at-rest signal changes to 1 (on the ground, motors off) or 0. Throws InputError as
/// ReadStampedCsv does.
std::vector<ImuReading> ReadImuFile(const std::filesystem::path& file, const models::TimeBase& time);

}  // namespace touchdown::datasets
