#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "sim/dynamics/mujoco_errors.h"
#include "sim/dynamics/world.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using tests::QuietWorld;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Runs in a separate folder, where MuJoCo would write MUJOCO_LOG.TXT.
class WorldErrors : public ::testing::Test {
 protected:
  WorldErrors() {
    folder_ = std::filesystem::temp_directory_path() /
              ("touchdown_world_errors_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    std::filesystem::current_path(folder_);
  }
  ~WorldErrors() override {
    EXPECT_TRUE(std::filesystem::is_empty(folder_)) << "MuJoCo wrote a log";
    std::filesystem::current_path(start_);
    std::filesystem::remove_all(folder_);
  }

  std::filesystem::path start_ = std::filesystem::current_path();
  std::filesystem::path folder_;
  World world_ = QuietWorld({});
};

TEST_F(WorldErrors, ThrowsForACommandThatIsNotFinite) {
  EXPECT_THAT([&] { world_.Step(tests::SameSpeed(kNan)); }, ThrowsMessage<SimulationError>(HasSubstr("command")));
  EXPECT_THAT([&] { world_.Step(tests::SameSpeed(std::numeric_limits<double>::infinity())); },
              ThrowsMessage<SimulationError>(HasSubstr("command")));
  EXPECT_EQ(world_.state().tick, 0);
}

TEST_F(WorldErrors, ThrowsForAWindThatIsNotFinite) {
  world_.SetWind({0.0, kNan, 0.0});
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("force")));
}

TEST_F(WorldErrors, ThrowsForAPushThatIsNotFinite) {
  world_.SetPush({kNan, 0.0, 0.0}, Vector3d::Zero());
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("force")));
  world_.SetPush(Vector3d::Zero(), {0.0, 0.0, std::numeric_limits<double>::infinity()});
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("force")));
}

TEST_F(WorldErrors, ThrowsWhenMujocoWarnsAboutAForce) {
  world_.SetPush({1e15, 0.0, 0.0}, Vector3d::Zero());
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("MuJoCo")));
}

TEST_F(WorldErrors, ThrowsWhenMujocoWarnsAboutATorque) {
  world_.SetPush(Vector3d::Zero(), {0.0, 1e15, 0.0});
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("MuJoCo")));
}

TEST_F(WorldErrors, ThrowsWhenMujocoRejectsTheState) {
  world_.data().qpos[0] = kNan;
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("MuJoCo")));
}

TEST_F(WorldErrors, ThrowsWhenTheTimeDoesNotAdvance) {
  const_cast<mjModel&>(world_.model()).opt.timestep = 0.0;
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("time")));
}

TEST_F(WorldErrors, AcceptsCommandsAfterAReset) {
  world_.SetPush({1e15, 0.0, 0.0}, Vector3d::Zero());
  EXPECT_THROW(world_.Step({}), SimulationError);
  world_.Reset(world_.RestingPose(0.0, 0.0, 0.0), false);
  EXPECT_NO_THROW(world_.Step({}));
  EXPECT_EQ(world_.state().tick, 1);
}

TEST_F(WorldErrors, ThrowsForAnyOtherWarningOfMujoco) {
  mju_warning("the renderer ran out of geoms");
  EXPECT_THAT([&] { world_.Step({}); }, ThrowsMessage<SimulationError>(HasSubstr("ran out of geoms")));
}

TEST_F(WorldErrors, ThrowsForAnErrorInsideMujoco) { EXPECT_THROW(mju_error("out of memory"), SimulationError); }

TEST_F(WorldErrors, ThrowsForAPoseThatIsNotFinite) {
  Eigen::Isometry3d nowhere = Eigen::Isometry3d::Identity();
  nowhere.translation().x() = kNan;
  EXPECT_THROW(world_.Reset(nowhere, false), SimulationError);
}

}  // namespace
}  // namespace touchdown::sim
