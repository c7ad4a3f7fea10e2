#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

namespace touchdown::datasets {

/// Where a body was, as somebody's file tells.
struct TimedPose {
  double t_s = 0.0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// The trajectory of a file in the format of the TUM RGB-D benchmark: lines of t_s x_m y_m z_m qx qy qz qw, comments
/// after #. Throws InputError, naming file and line, for a file that cannot be read or has no poses, a line that is not
/// of eight finite numbers, a quaternion that is not of length 1 and a time that does not rise.
std::vector<TimedPose> ReadTumFile(const std::filesystem::path& file);

}  // namespace touchdown::datasets
