#include "scenarios/laboratory/calibration_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/angles.h"
#include "models/error.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::laboratory {
namespace {

using models::DegToRad;
using models::RadToDeg;
using ::testing::HasSubstr;

runner::Scenario MisalignedVehicle(std::uint64_t seed) {
  runner::Scenario scenario;
  scenario.seed = seed;
  scenario.vehicle.camera = {.position_m = {0.03, -0.01, -0.04}, .misalignment_deg = {1.0, -2.0, 3.0}};
  scenario.vehicle.imu.misalignment_deg = {2.0, -1.0, 0.0};
  return scenario;
}

TEST(CalibrationBench, EstimatesTheTiltOfAnIdealImuExactly) {
  runner::Scenario scenario = MisalignedVehicle(1);
  scenario.imu.accelerometer_bias_sigma_m_s2 = 0.0;
  scenario.imu.accelerometer_noise_m_s2_sqrt_hz = 0.0;
  const ImuCalibration imu = CalibrateImu(scenario);
  EXPECT_LT(imu.tilt_error_rad, 1e-9);
  EXPECT_NEAR(imu.mounting.misalignment_deg.roll, 2.0, 0.02) << "up to the effect of a small yaw";
  EXPECT_NEAR(imu.mounting.misalignment_deg.pitch, -1.0, 0.02);
}

TEST(CalibrationBench, HasATiltErrorFromTheTurnOnBias) {
  runner::Scenario scenario = MisalignedVehicle(1);
  double squared = 0.0;
  constexpr int kSeeds = 200;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    scenario.seed = static_cast<std::uint64_t>(seed);
    const double error = CalibrateImu(scenario, 1.0).tilt_error_rad;
    squared += error * error / kSeeds;
  }
  const double expected = std::sqrt(2.0) * scenario.imu.accelerometer_bias_sigma_m_s2 / models::kGravity_m_s2;
  EXPECT_NEAR(std::sqrt(squared) / expected, 1.0, 0.15);
}

TEST(CalibrationBench, EstimatesTheCameraWithinItsNoise) {
  const runner::Scenario scenario = MisalignedVehicle(1);
  const CameraCalibration camera = CalibrateCamera(scenario);
  EXPECT_GE(camera.views_used(), 24);
  EXPECT_LT(camera.fit.rms_px, 0.15);
  EXPECT_LT(camera.focal_error_px, 0.3);
  EXPECT_LT(camera.principal_point_error_px, 0.5);
  EXPECT_LT(camera.position_error_m, 0.002);
  EXPECT_LT(RadToDeg(camera.rotation_error_rad), 0.1);
  EXPECT_TRUE(camera.mounting.position_m.isApprox(scenario.vehicle.camera.position_m, 0.1));
  EXPECT_NEAR(camera.mounting.misalignment_deg.yaw, 3.0, 0.1);
}

TEST(CalibrationBench, HasSmallerErrorsWithoutNoise) {
  runner::Scenario scenario = MisalignedVehicle(2);
  scenario.camera.noise_sigma = 0.0;
  auto& tracking = std::get<sim::TrackingSystemConfig>(scenario.sensors);
  tracking.position_noise_m = tracking.rotation_noise_deg = tracking.occlusions_per_s = 0.0;
  CameraCalibrationConfig config;
  config.views = 9;
  const CameraCalibration camera = CalibrateCamera(scenario, config);
  EXPECT_LT(camera.fit.rms_px, 0.1);
  EXPECT_LT(camera.position_error_m, 0.001);
  EXPECT_LT(RadToDeg(camera.rotation_error_rad), 0.05);
}

TEST(CalibrationBench, IsReproducibleAndToleratesOcclusions) {
  runner::Scenario scenario = MisalignedVehicle(3);
  std::get<sim::TrackingSystemConfig>(scenario.sensors).occlusions_per_s = 1.0;
  CameraCalibrationConfig config;
  config.views = 9;
  const CameraCalibration first = CalibrateCamera(scenario, config), again = CalibrateCamera(scenario, config);
  EXPECT_EQ(first.fit.model, again.fit.model);
  EXPECT_EQ(first.X_BC.X_AB.matrix(), again.X_BC.X_AB.matrix());
  EXPECT_LT(first.position_error_m, 0.003);
  scenario.seed = 4;
  EXPECT_NE(CalibrateCamera(scenario, config).fit.model, first.fit.model);
}

TEST(CalibrationBench, StopsWhenTheProgressFunctionThrows) {
  EXPECT_THROW(CalibrateCamera(runner::Scenario(), {}, [](double) { throw util::Interrupted(); }), util::Interrupted);
}

TEST(CalibrationBench, RejectsACameraWithTooFewPixels) {
  runner::Scenario tiny = MisalignedVehicle(1);
  tiny.camera.model.width_px = tiny.camera.model.height_px = 24;
  tiny.camera.model.cx_px = tiny.camera.model.cy_px = 11.5;
  CameraCalibrationConfig config;
  config.views = 4;
  try {
    CalibrateCamera(tiny, config);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("calibration pattern"));
  }
}

}  // namespace
}  // namespace touchdown::laboratory
