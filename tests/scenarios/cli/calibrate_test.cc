// `touchdown calibrate`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/runner/scenario.h"
#include "tests/support/program_fixture.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class CalibrateCommand : public tests::ProgramFixture {
 protected:
  void SetUp() override {
    folder_.Put("skew.yaml",
                "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.1}]\n"
                "vehicle: {camera: {misalignment_deg: [1, -2, 3]}, imu: {misalignment_deg: [2, -1, 0]}}\n");
  }
};

TEST_F(CalibrateCommand, WritesACalibrationThatAScenarioUses) {
  const tests::ProgramRun run = Run({"calibrate", "all", "skew.yaml", "--out", "found", "--seed", "2"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("error: tilt"), HasSubstr("error: focal"), HasSubstr("found/calibration.yaml")));
  for (const char* name : {"calibration.json", "calibration.yaml", "camera.yaml", "views.png"}) {
    EXPECT_TRUE(fs::exists(folder_ / "found" / name)) << name;
  }
  const runner::Calibration found = runner::LoadCalibration(folder_ / "found/calibration.yaml");
  ASSERT_TRUE(found.camera_model && found.camera && found.imu);
  EXPECT_EQ(runner::LoadCameraModel(folder_ / "found/camera.yaml"), *found.camera_model);
  EXPECT_EQ(runner::CalibrationYaml(found), folder_.Content("found/calibration.yaml"));

  folder_.Put("fly.yaml", folder_.Content("skew.yaml") + "calibration: found/calibration.yaml\n");
  EXPECT_EQ(Run({"fly", "fly.yaml", "--out", "flight", "--video", "off"}).status, 0);
  EXPECT_EQ(runner::LoadScenario(folder_ / "flight/scenario.yaml").assumed_camera(), *found.camera_model);
}

TEST_F(CalibrateCommand, CalibratesOnlyTheImuFromAScenarioOrRealSamples) {
  EXPECT_EQ(
      Run({"calibrate", "imu", "skew.yaml", "--out", "imu", "--set", "imu.accelerometer_bias_sigma_m_s2=0"}).status, 0);
  const runner::Calibration found = runner::LoadCalibration(folder_ / "imu/calibration.yaml");
  EXPECT_FALSE(found.camera || found.camera_model);
  EXPECT_THAT(folder_.Content("imu/calibration.json"), HasSubstr("\"not_observable\": \"yaw\""));

  std::string csv = "#timestamp [ns],w x,w y,w z,a x,a y,a z\n";
  for (int i = 0; i < 200; ++i) csv += std::to_string(5000000LL * i) + ",0,0,0,0,1.7035,9.661\n";
  folder_.Put("rest.csv", csv);
  const tests::ProgramRun real = Run({"calibrate", "imu", "--imu", "rest.csv", "--out", "real"});
  EXPECT_EQ(real.status, 0) << real.err;
  EXPECT_THAT(real.out, HasSubstr("roll 10.000 deg"));
  EXPECT_THAT(folder_.Content("real/calibration.json"), Not(HasSubstr("\"error\"")));
}

TEST_F(CalibrateCommand, RejectsInvalidInputWithOneLine) {
  folder_.Put("few.csv", "#timestamp [ns],w x,w y,w z,a x,a y,a z\n0,0,0,0,0,0,9.81\n");
  folder_.Put("mine/notes.txt", "mine");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"calibrate", "lens", "skew.yaml", "--out", "result"}, "lens"},
      {{"calibrate", "imu", "--out", "result"}, "needs SCENARIO"},
      {{"calibrate", "imu", "none.yaml", "--out", "result"}, "none.yaml"},
      {{"calibrate", "camera", "--imu", "few.csv", "--out", "result"}, "works only with calibrate imu"},
      {{"calibrate", "imu", "--imu", "few.csv", "--out", "result"}, "few.csv: too few samples of the IMU at rest: 1"},
      {{"calibrate", "imu", "skew.yaml", "--set", "camera.fps=3", "--out", "result"}, "camera.fps: unknown key"},
      {{"calibrate", "imu", "skew.yaml", "--out", "mine"}, "mine"},
  };
  const std::set<std::string> before = Names();
  for (const auto& [arguments, error] : cases) {
    EXPECT_THAT(ErrorOf(arguments), HasSubstr(error));
    EXPECT_EQ(Names(), before);
  }
}

}  // namespace
}  // namespace touchdown::cli
