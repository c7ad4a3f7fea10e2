#include "scenarios/datasets/tum_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "models/error.h"
#include "scenarios/util/file.h"

namespace touchdown::datasets {
namespace {

/// Parses a line. Throws InputError, without file and line.
TimedPose ParseLine(const std::string& line) {
  std::istringstream stream(line);
  std::array<double, 8> numbers{};
  std::string rest;
  for (double& number : numbers) {
    if (!(stream >> number) || !std::isfinite(number)) throw InputError("must be eight numbers: t x y z qx qy qz qw");
  }
  if (stream >> rest) throw InputError("must be exactly eight numbers: t x y z qx qy qz qw");
  const auto& [t_s, x, y, z, qx, qy, qz, qw] = numbers;
  const Eigen::Quaterniond q(qw, qx, qy, qz);
  constexpr double kRoundOff = 1e-2;
  if (std::abs(q.norm() - 1.0) > kRoundOff)
    throw InputError(fmt::format("quaternion has length {}; must be 1", q.norm()));
  TimedPose pose;
  pose.t_s = t_s;
  pose.X_WB.linear() = q.normalized().toRotationMatrix();
  pose.X_WB.translation() << x, y, z;
  return pose;
}

}  // namespace

std::vector<TimedPose> ReadTumFile(const std::filesystem::path& file) {
  std::istringstream stream(util::ReadTextFile(file));
  std::vector<TimedPose> poses;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (const std::size_t begin = line.find_first_not_of(" \t\r"); begin == std::string::npos || line[begin] == '#') {
      continue;
    }
    try {
      const TimedPose pose = ParseLine(line);
      if (!poses.empty() && pose.t_s <= poses.back().t_s) throw InputError("time is not after that of the pose before");
      poses.push_back(pose);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}:{}: {}", file.string(), number, error.what()));
    }
  }
  if (poses.empty()) throw InputError(fmt::format("{}: no poses", file.string()));
  return poses;
}

}  // namespace touchdown::datasets
