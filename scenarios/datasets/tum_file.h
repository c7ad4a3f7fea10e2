#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

namespace touchdown::datasets {

/// Pose of the body at a time.
struct TimedPose {
  double t_s = 0.0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// Reads a trajectory in the format of the TUM RGB-D benchmark: lines of t_s x_m y_m z_m qx qy qz qw. Lines that begin
/// with # are comments. Throws InputError, naming file and line, for a file that cannot be read or has no poses, a line
/// other than eight finite numbers, a quaternion whose length is not 1, and a time that does not increase.
std::vector<TimedPose> ReadTumFile(const std::filesystem::path& file);

}  // namespace touchdown::datasets
