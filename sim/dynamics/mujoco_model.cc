#include "sim/dynamics/mujoco_model.h"

#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <new>
#include <stdexcept>

#include "sim/dynamics/mujoco_errors.h"

namespace touchdown::sim {
namespace {

struct VfsDeleter {
  void operator()(mjVFS* vfs) const {
    mj_deleteVFS(vfs);
    delete vfs;
  }
};

std::unique_ptr<mjVFS, VfsDeleter> VfsWith(const char* name, const std::string& content) {
  std::unique_ptr<mjVFS, VfsDeleter> vfs(new mjVFS);
  mj_defaultVFS(vfs.get());
  if (mj_makeEmptyFileVFS(vfs.get(), name, static_cast<int>(content.size())) != 0) {
    throw std::runtime_error("MuJoCo's virtual file system rejected a model of " + std::to_string(content.size()) +
                             " bytes");
  }
  std::memcpy(vfs->filedata[mj_findFileVFS(vfs.get(), name)], content.data(), content.size());
  return vfs;
}

}  // namespace

void MujocoModelDeleter::operator()(mjModel_* model) const { mj_deleteModel(model); }
void MujocoDataDeleter::operator()(mjData_* data) const { mj_deleteData(data); }

MujocoModel LoadModel(const std::string& mjcf) {
  InstallMujocoHandlers();
  constexpr const char* kName = "touchdown.xml";
  const auto vfs = VfsWith(kName, mjcf);
  std::array<char, 1024> error{};
  MujocoModel model(mj_loadXML(kName, vfs.get(), error.data(), static_cast<int>(error.size())));
  ThrowIfOutOfMemory(error.data());
  if (!model || error[0] != '\0') throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  return model;
}

MujocoData MakeData(const mjModel_& model) {
  MujocoData data(mj_makeData(&model));
  if (!data) throw std::bad_alloc();
  mj_forward(&model, data.get());
  return data;
}

void SetFreePose(const Eigen::Isometry3d& X_WB, mjData_& data) {
  const Eigen::Quaterniond q_WB(X_WB.linear());
  Eigen::Map<Eigen::Vector3d>(data.qpos) = X_WB.translation();
  Eigen::Map<Eigen::Vector4d>(data.qpos + 3) << q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z();
}

}  // namespace touchdown::sim
