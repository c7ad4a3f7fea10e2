// Sections of a scenario that are keys or the name of a file: camera, pad, vehicle, calibration.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/angles.h"
#include "models/error.h"
#include "scenarios/config/camera_info.h"
#include "scenarios/runner/scenario.h"
#include "tests/support/scenario_text.h"

namespace touchdown::runner {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tests::ErrorOf;
using tests::Parse;
using tests::With;

constexpr const char* kMarks = R"(pad:
  marks:
    - {shape: disc, x_m: 0.02, y_m: 0.05, diameter_m: 0.01}
    - {shape: bar, x_m: -0.02, y_m: 0.05, length_m: 0.02, width_m: 0.004, angle_deg: 30}
)";

TEST(Scenario, ReadsPadMarks) {
  const models::PadMarking disc{
      .shape = models::PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01};
  const models::PadMarking bar{.shape = models::PadMarking::Shape::kBar,
                               .center_m = {-0.02, 0.05},
                               .length_m = 0.02,
                               .width_m = 0.004,
                               .angle_deg = 30.0};
  EXPECT_EQ(Parse(With(kMarks)).pad.marks, (std::vector{disc, bar}));
  EXPECT_EQ(Parse(With("")).pad.marks.size(), 0u);
  EXPECT_EQ(Parse(With(kMarks), {"pad.marks.0.x_m=0.03"}).pad.marks[0].center_m.x(), 0.03);
}

TEST(Scenario, RejectsInvalidPadMarkWithLineAndKey) {
  // Text of the marks, its replacement, and the expected error.
  const struct {
    std::string written, instead, error;
  } cases[] = {
      {"shape: disc", "shape: star", "f.yaml:6: pad.marks.0.shape: must be one of disc, bar, is 'star'"},
      {"shape: disc, ", "", "f.yaml:6: pad.marks.0.shape: must be given"},
      {"x_m: 0.02, ", "", "f.yaml:6: pad.marks.0.x_m: must be given"},
      {", diameter_m: 0.01", "", "f.yaml:6: pad.marks.0.diameter_m: must be given"},
      {"diameter_m: 0.01", "diameter_m: -0.01", "f.yaml:6: pad.marks.0.diameter_m: must be above 0, is -0.01"},
      {"diameter_m: 0.01", "diameter_m: 0.01, angle_deg: 3", "f.yaml:6: pad.marks.0.angle_deg: unknown key"},
      {"diameter_m: 0.01", "radius_m: 0.01", "f.yaml:6: pad.marks.0.diameter_m: must be given"},
      {"length_m: 0.02, ", "", "f.yaml:7: pad.marks.1.length_m: must be given"},
      {", width_m: 0.004", "", "f.yaml:7: pad.marks.1.width_m: must be given"},
      {"width_m: 0.004", "width_m: 0.004, diameter_m: 1", "f.yaml:7: pad.marks.1.diameter_m: unknown key"},
      {"angle_deg: 30", "angle_deg: 300", "f.yaml:7: pad.marks.1.angle_deg: must be from -180 to 180, is 300"},
      {"x_m: -0.02", "x_m: 0.06", "f.yaml:7: pad.marks.1: a marking of the pad must be entirely within its ring"},
  };
  for (const auto& [written, instead, error] : cases) {
    std::string text = kMarks;
    ASSERT_NE(text.find(written), std::string::npos) << written;
    text.replace(text.find(written), written.size(), instead);
    EXPECT_THAT(ErrorOf(With(text)), StartsWith(error));
  }
  EXPECT_THAT(ErrorOf(With("pad: {marks: 3}\n")), StartsWith("f.yaml:4: pad.marks: must be a list"));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.ring_width_m=0.032"}), StartsWith("f.yaml:6: pad.marks.0: "));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.marks.0.shape=bar"}),
              StartsWith("--set pad.marks.0.shape=bar: pad.marks.0.length_m: must be above 0, is 0"));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.marks.2.x_m=0"}), HasSubstr("pad.marks.2: unknown key"));
}

class ScenarioWithFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void Put(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }
  Scenario Load(const std::string& lines) const {
    Put("flight.yaml", With(lines));
    return LoadScenario(folder_ / "flight.yaml");
  }
  std::string LoadError(const std::string& lines) const {
    try {
      Load(lines);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
  }
  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("scenario_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

constexpr const char* kCameraInfo = R"(image_width: 752
image_height: 480
camera_name: cam0
camera_matrix: {rows: 3, cols: 3, data: [458.654, 0, 367.215, 0.0, 457.296, 248.375, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.28340811, 0.07395907, 0.0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [458, 0, 367, 0, 0, 457, 248, 0, 0, 0, 1, 0]}
)";

TEST_F(ScenarioWithFiles, ReadsRosCalibrationFromFile) {
  Put("camera.yaml", kCameraInfo);
  for (const char* lines : {"camera: camera.yaml\n", "camera: {model: camera.yaml, rate_hz: 30}\n"}) {
    const models::CameraModel model = Load(lines).camera.model;
    EXPECT_EQ(model.width_px, 752);
    EXPECT_EQ(model.height_px, 480);
    EXPECT_EQ(model.fx_px, 458.654);
    EXPECT_EQ(model.fy_px, 457.296);
    EXPECT_EQ(model.cx_px, 367.215);
    EXPECT_EQ(model.cy_px, 248.375);
    EXPECT_EQ(model.k1, -0.28340811);
    EXPECT_EQ(model.k2, 0.07395907);
    EXPECT_EQ(LoadCameraModel(folder_ / "camera.yaml"), model);
  }
}

TEST_F(ScenarioWithFiles, ReadsAndWritesFiveDistortionCoefficients) {
  std::string text = kCameraInfo;
  text.replace(text.find("0.0, 0, 0]"), 10, "1e-4, -2e-4, 0.003]");
  Put("camera.yaml", text);
  const models::CameraModel model = LoadCameraModel(folder_ / "camera.yaml");
  EXPECT_EQ(model.p1, 1e-4);
  EXPECT_EQ(model.p2, -2e-4);
  EXPECT_EQ(model.k3, 0.003);
  Put("again.yaml", config::CameraInfoYaml(model, "cam0"));
  EXPECT_EQ(LoadCameraModel(folder_ / "again.yaml"), model);
}

TEST_F(ScenarioWithFiles, RejectsInvalidRosCalibrationWithLineAndKey) {
  // Text of the calibration, its replacement, and the expected error in the calibration file.
  const struct {
    std::string written, instead, error;
  } cases[] = {
      {"plumb_bob", "equidistant", "camera.yaml:5: distortion_model: must be plumb_bob, is 'equidistant'"},
      {"camera_name: cam0", "camera_nmae: cam0", "camera.yaml:3: camera_nmae: unknown key, did you mean camera_name?"},
      {"rows: 3, cols: 3, data: [458", "rows: 3, skew: 0, cols: 3, data: [458",
       "camera.yaml:4: camera_matrix.skew: unknown key"},
      {"image_width: 752", "image_width: 752.5", "camera.yaml:1: image_width: must be an integer"},
      {"image_width: 752", "image_width: 0", "camera.yaml:1: image_width: must be from 1 to 16384"},
      {"image_width: 752", "", "image_width: must be given"},
      {"data: [458.654", "data: [wide", "camera.yaml:4: camera_matrix.data.0: must be a number, is 'wide'"},
      {"data: [458.654", "data: [-458.654",
       "camera.yaml:4: camera_matrix.data: must be [fx, 0, cx, 0, fy, cy, 0, 0, 1]"},
      {"data: [458.654, 0,", "data: [458.654, 2,", "camera.yaml:4: camera_matrix.data: must be [fx, 0, cx"},
      {"data: [458.654, 0,", "data: [458.654,", "camera.yaml:4: camera_matrix.data: must be a list of 9 numbers"},
      {"rows: 3, cols: 3, data: [458", "rows: 2, cols: 3, data: [458",
       "camera.yaml:4: camera_matrix.rows: must be 3, is 2"},
      {"rows: 3, cols: 3, data: [458", "cols: 3, data: [458", "camera.yaml:4: camera_matrix.rows: must be given"},
      {"rows: 1, cols: 5", "rows: 1, cols: 4",
       "camera.yaml:6: distortion_coefficients.data: must be a list of 4 numbers"},
      {"rows: 1, cols: 5", "rows: 1, cols: 8", "camera.yaml:6: distortion_coefficients.cols: must be from 4 to 5"},
      {"-0.28340811", "-0.9", "camera.yaml:6: distortion_coefficients.data: the camera's distortion is not invertible"},
      {"data: [1, 0, 0,", "data: [1, 0.1, 0,", "camera.yaml:7: rectification_matrix.data: must be [1, 0, 0"},
      {"367, 0, 0, 457", "367, -50, 0, 457", "camera.yaml:8: projection_matrix.data: must be [fx', 0, cx', 0,"},
      {"rows: 3, cols: 4", "rows: 3, cols: 3", "camera.yaml:8: projection_matrix.cols: must be 4, is 3"},
  };
  for (const auto& [written, instead, error] : cases) {
    std::string text = kCameraInfo;
    ASSERT_NE(text.find(written), std::string::npos) << written;
    text.replace(text.find(written), written.size(), instead);
    Put("camera.yaml", text);
    EXPECT_THAT(LoadError("camera: camera.yaml\n"), AllOf(HasSubstr("flight.yaml:4: camera: "), HasSubstr(error)));
  }
}

TEST_F(ScenarioWithFiles, ReadsPadAndVehicleFromFilesAndWritesTheirKeys) {
  Put("pad.yaml", "outer_radius_m: 0.08\n");
  Put("heavy.yaml", "mass_kg: 1.5\n");
  const Scenario scenario = Load("pad: pad.yaml\nvehicle: heavy.yaml\n");
  EXPECT_EQ(scenario.pad.outer_radius_m, 0.08);
  EXPECT_EQ(scenario.vehicle.mass_kg, 1.5);
  EXPECT_EQ(LoadPad(folder_ / "pad.yaml"), scenario.pad);
  EXPECT_EQ(ParseScenario(ScenarioYaml(scenario), "f", "/nowhere").pad, scenario.pad);
}

TEST_F(ScenarioWithFiles, WritesPadMarksThatReadBack) {
  const models::LandingPad pad = Parse(With(kMarks), {"pad.marks.1.angle_deg=-12.345678901234567"}).pad;
  Put("pad.yaml", PadYaml(pad));
  EXPECT_EQ(LoadPad(folder_ / "pad.yaml"), pad);
  const Scenario scenario = Load("pad: pad.yaml\n");
  EXPECT_EQ(scenario.pad, pad);
  EXPECT_EQ(ParseScenario(ScenarioYaml(scenario), "f", "/nowhere").pad, pad);
}

TEST(ScenarioCalibration, EqualsTruthIfAbsent) {
  const Scenario plain = Parse(With("vehicle: {camera: {misalignment_deg: [1, 2, 3]}}\n"));
  EXPECT_EQ(plain.assumed_camera(), plain.camera.model);
  EXPECT_EQ(plain.assumed_vehicle().X_BC().matrix(), plain.vehicle.X_BC().matrix());
  EXPECT_EQ(plain.assumed_vehicle().X_BU().matrix(), plain.vehicle.X_BU().matrix());
  EXPECT_THAT(ScenarioYaml(plain), Not(HasSubstr("calibration"))) << "a resolved scenario follows its truth";
  EXPECT_NO_THROW(Parse(With("calibration: {}\n")));

  const Scenario partly =
      Parse(With("calibration: {camera: {misalignment_deg: [4, 5, 6]}, camera_model: {fx_px: 321}}\n"),
            {"vehicle.camera.position_m=[0.1, 0, -0.02]", "camera.model.k1=-0.12"});
  EXPECT_EQ(partly.calibration.camera->position_m, Eigen::Vector3d(0.1, 0.0, -0.02)) << "the truth, as overridden";
  EXPECT_EQ(partly.assumed_camera().fx_px, 321.0);
  EXPECT_EQ(partly.assumed_camera().k1, -0.12);
  EXPECT_EQ(partly.camera.model.fx_px, 320.0) << "the truth stays";
  EXPECT_FALSE(partly.calibration.imu);
}

TEST(ScenarioCalibration, ReadsBackBitIdentical) {
  const Scenario scenario =
      Parse(With("calibration: {camera: {misalignment_deg: [1.2345678901234567, 0.1, 3]}, imu: {misalignment_deg: "
                 "[0.3, 0.7, 1]}}\n"),
            {"calibration.camera_model.k2=0.012345678901234567", "calibration.imu.misalignment_deg.2=-1.1"});
  const std::string yaml = ScenarioYaml(scenario);
  const Scenario again = ParseScenario(yaml, "f", "/nowhere");
  EXPECT_EQ(ScenarioYaml(again), yaml);
  EXPECT_EQ(again.assumed_camera(), scenario.assumed_camera());
  EXPECT_EQ(again.assumed_vehicle().X_BC().matrix(), scenario.assumed_vehicle().X_BC().matrix());
  EXPECT_EQ(again.assumed_vehicle().X_BU().matrix(), scenario.assumed_vehicle().X_BU().matrix());
  EXPECT_EQ(again.calibration.imu->misalignment_deg.yaw, -1.1);
}

TEST(ScenarioCalibration, ReportsErrors) {
  EXPECT_THAT(ErrorOf(With("calibration: {lens: 3}\n")), StartsWith("f.yaml:4: calibration.lens: unknown key"));
  EXPECT_THAT(ErrorOf(With("calibration: {imu: {yaw: 3}}\n")), HasSubstr("calibration.imu.yaw: unknown key"));
  EXPECT_THAT(ErrorOf(With("calibration: {camera_model: {width_px: 320}}\n")),
              StartsWith("f.yaml:4: calibration.camera_model: is for 320 x 480 px, but the camera has"));
  EXPECT_THAT(
      ErrorOf(With("calibration: {camera: {position_m: [0, 0, -1]}}\n")),
      StartsWith("f.yaml:4: calibration.camera: the vehicle's camera must be above the landing gear contact points"));
}

TEST_F(ScenarioWithFiles, ReadsCalibrationFileWithRosCameraModel) {
  std::string camera = kCameraInfo;
  Put("camera.yaml", camera);
  Put("calibration.yaml", "camera_model: camera.yaml\nimu: {misalignment_deg: [1, 0, 0]}\n");
  const Scenario scenario = Load("calibration: calibration.yaml\ncamera: {model: {width_px: 752, cx_px: 375.5}}\n");
  EXPECT_EQ(scenario.assumed_camera(), LoadCameraModel(folder_ / "camera.yaml"));
  EXPECT_NE(scenario.camera.model.fx_px, 458.654);
  EXPECT_EQ(scenario.assumed_vehicle().imu.misalignment_deg.roll, 1.0);
  Put("again.yaml", CalibrationYaml(LoadCalibration(folder_ / "calibration.yaml")));
  EXPECT_EQ(CalibrationYaml(LoadCalibration(folder_ / "again.yaml")),
            CalibrationYaml(LoadCalibration(folder_ / "calibration.yaml")));
}

TEST_F(ScenarioWithFiles, ReportsFileAndKeyThatRefersToIt) {
  EXPECT_THAT(LoadError("pad: none.yaml\n"),
              AllOf(HasSubstr("flight.yaml:4: pad: "), HasSubstr("none.yaml: no such file")));
  Put("pad.yaml", "\nradius: 1\n");
  EXPECT_THAT(LoadError("pad: pad.yaml\n"), HasSubstr("pad.yaml:2: pad.radius: unknown key"));
  Put("pad.yaml", "marks:\n  - shape: disc\n    x_m: 0.07\n    y_m: 0\n    diameter_m: 0.01\n");
  EXPECT_THAT(LoadError("pad: pad.yaml\n"),
              HasSubstr("pad.yaml:2: pad.marks.0: a marking of the pad must be entirely"));
}

}  // namespace
}  // namespace touchdown::runner
