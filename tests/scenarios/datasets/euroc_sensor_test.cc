#include "scenarios/datasets/euroc_sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/vehicle.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

using ::testing::HasSubstr;
using tests::ThrowsInputError;

/// A sensor.yaml as in the data sets, with keys that are not read.
constexpr const char* kSensor = R"(#Default camera
sensor_type: camera
comment: a camera
T_BS:
  cols: 4
  rows: 4
  data: [0.0, -1.0, 0.0, -0.02,
         1.0, 0.0, 0.0, -0.06,
         0.0, 0.0, 1.0, 0.01,
         0.0, 0.0, 0.0, 1.0]
rate_hz: 20
resolution: [752, 480]
camera_model: pinhole
intrinsics: [458.654, 457.296, 367.215, 248.375] #fu, fv, cu, cv
distortion_model: radial-tangential
distortion_coefficients: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]
)";

class EurocSensorTest : public ::testing::Test {
 protected:
  /// Reads kSensor after replacing `original` with `replacement`.
  auto ReadingWith(const std::string& original, const std::string& replacement) const {
    std::string text = kSensor;
    text.replace(text.find(original), original.size(), replacement);
    return [this, text] { ReadEurocCamera(folder_.Put("sensor.yaml", text)); };
  }
  tests::TemporaryFolder folder_;
};

TEST_F(EurocSensorTest, ReadsACameraAndItsMounting) {
  const EurocCamera camera = ReadEurocCamera(folder_.Put("sensor.yaml", kSensor));
  EXPECT_EQ(camera.model.width_px, 752);
  EXPECT_EQ(camera.model.fy_px, 457.296);
  EXPECT_EQ(camera.model.cx_px, 367.215);
  EXPECT_EQ(camera.model.k2, 0.07395907);
  EXPECT_EQ(camera.model.p1, 0.00019359);
  EXPECT_EQ(camera.X_BC.translation(), Eigen::Vector3d(-0.02, -0.06, 0.01));
  EXPECT_EQ(camera.X_BC.linear().col(0), Eigen::Vector3d::UnitY());
}

TEST_F(EurocSensorTest, ReadsBackBitIdenticalValues) {
  models::Vehicle vehicle;
  vehicle.camera.misalignment_deg = {0.6, -1.1, 17.0};
  vehicle.imu.misalignment_deg = {6.0, 11.0, -1.7};
  models::CameraModel model;
  model.fx_px = 320.0 / 3.0;
  model.k1 = -0.1;
  const EurocCamera camera = ReadEurocCamera(folder_.Put("camera.yaml", EurocCameraYaml({model, vehicle.X_BC()}, 60)));
  EXPECT_EQ(camera.model, model);
  EXPECT_EQ(camera.X_BC.matrix(), vehicle.X_BC().matrix());
  const Eigen::Isometry3d X_BU =
      ReadEurocMounting(folder_.Put("imu.yaml", EurocImuYaml(vehicle.X_BU(), 200, 1e-4, 1e-3)));
  EXPECT_EQ(X_BU.matrix(), vehicle.X_BU().matrix());
}

TEST_F(EurocSensorTest, NamesFileLineAndKeyOfAnError) {
  EXPECT_THAT(ReadingWith("radial-tangential", "equidistant"),
              ThrowsInputError(HasSubstr("sensor.yaml:15: distortion_model: must be radial-tangential")));
  EXPECT_THAT(ReadingWith("[0.0, -1.0,", "[0.1, -1.0,"),
              ThrowsInputError(HasSubstr("T_BS.data: must be a rigid transform: a rotation")));
  EXPECT_THAT(ReadingWith("resolution: [752, 480]", ""), ThrowsInputError(HasSubstr("resolution: must be given")));
  EXPECT_THAT(ReadingWith("intrinsics: [458.654", "intrinsics: [-458.654"),
              ThrowsInputError(HasSubstr("must be above 0")));
}

}  // namespace
}  // namespace touchdown::datasets
