#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

struct mjModel_;
struct mjData_;

namespace touchdown::sim {

struct MujocoModelDeleter {
  void operator()(mjModel_* model) const;
};
struct MujocoDataDeleter {
  void operator()(mjData_* data) const;
};

using MujocoModel = std::unique_ptr<mjModel_, MujocoModelDeleter>;
using MujocoData = std::unique_ptr<mjData_, MujocoDataDeleter>;

/// Compiles an MJCF document held in memory. Throws std::runtime_error with MuJoCo's message when it does not
/// compile, or compiles with a warning.
MujocoModel LoadModel(const std::string& mjcf);

/// Makes the state of `model` at its initial configuration, with kinematics, lights and cameras computed.
MujocoData MakeData(const mjModel_& model);

/// Sets the pose of the body that has the model's first free joint. Does not compute kinematics.
void SetFreePose(const Eigen::Isometry3d& X_WB, mjData_& data);

}  // namespace touchdown::sim
