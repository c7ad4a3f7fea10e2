#include "sim/dynamics/mujoco_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <new>
#include <stdexcept>
#include <string>

namespace touchdown::sim {
namespace {

TEST(LoadModel, CompilesADocumentFromMemory) {
  const MujocoModel model = LoadModel("<mujoco><worldbody><geom name='ball' size='0.5'/></worldbody></mujoco>");
  EXPECT_EQ(model->ngeom, 1);
  EXPECT_EQ(mj_name2id(model.get(), mjOBJ_GEOM, "ball"), 0);
}

TEST(LoadModel, ReportsMujocosMessageForAnInvalidDocument) {
  try {
    LoadModel("<mujoco><worldbody><geom size='0.5' color='red'/></worldbody></mujoco>");
    FAIL() << "the invalid document compiled";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("color"));
  }
}

TEST(MakeData, ThrowsBadAllocWithoutMemoryLikeLoadModel) {
  const std::string mjcf = "<mujoco><worldbody><geom size='0.5'/></worldbody></mujoco>";
  const MujocoModel model = LoadModel(mjcf);
  mju_user_malloc = [](std::size_t) -> void* { return nullptr; };
  EXPECT_THROW(LoadModel(mjcf), std::bad_alloc);
  EXPECT_THROW(MakeData(*model), std::bad_alloc);
  mju_user_malloc = nullptr;
}

TEST(MakeData, HasKinematicsComputed) {
  const MujocoModel model =
      LoadModel("<mujoco><worldbody><body pos='1 2 3'><freejoint/><geom size='0.5'/></body></worldbody></mujoco>");
  const MujocoData data = MakeData(*model);
  EXPECT_DOUBLE_EQ(data->geom_xpos[2], 3.0);
}

}  // namespace
}  // namespace touchdown::sim
