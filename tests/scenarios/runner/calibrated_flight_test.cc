// Flights with a calibration that differs from the truth.
#include <gtest/gtest.h>

#include "models/angles.h"
#include "scenarios/runner/closed_loop.h"

namespace touchdown::runner {
namespace {

/// Hover of 0.08 s above the pad.
Scenario ShortHover() {
  Scenario scenario;
  scenario.start = {.airborne = true, .position_m = {0.0, 0.0, 1.0}};
  scenario.script = {{.kind = controller::ManeuverKind::kHover, .position_m = {0.0, 0.0, 1.0}, .duration_s = 60.0}};
  scenario.time_limit_s = 0.08;
  return scenario;
}

/// Vision pose of the first frame, on which the controller has no influence yet.
Eigen::Isometry3d FirstPose(const Scenario& scenario) {
  return FlyClosedLoop(scenario, {}, nullptr).frames.at(0).pose.value().X_WB;
}

TEST(CalibratedFlight, IsIdenticalWithTrueCalibration) {
  Scenario scenario = ShortHover();
  const FlightLog plain = FlyClosedLoop(scenario, {}, nullptr);
  scenario.calibration = {scenario.camera.model, scenario.vehicle.camera, scenario.vehicle.imu};
  const FlightLog calibrated = FlyClosedLoop(scenario, {}, nullptr);
  ASSERT_EQ(calibrated.ticks.size(), plain.ticks.size());
  EXPECT_EQ(calibrated.ticks.back().truth.X_WB.matrix(), plain.ticks.back().truth.X_WB.matrix());
  EXPECT_EQ(calibrated.frames.back().pose.value().X_WB.matrix(), plain.frames.back().pose.value().X_WB.matrix());
}

TEST(CalibratedFlight, HasErrorOfAssumedCameraMounting) {
  Scenario scenario = ShortHover();
  const Eigen::Isometry3d X_WB = FirstPose(scenario), X_BC = scenario.vehicle.X_BC();
  scenario.calibration.camera = models::Mounting{.position_m = {0.03, 0.0, -0.05}, .misalignment_deg = {.roll = 1.0}};
  const Eigen::Isometry3d wrong = FirstPose(scenario);
  EXPECT_TRUE(wrong.isApprox(X_WB * X_BC * scenario.assumed_vehicle().X_BC().inverse(), 1e-9))
      << "the camera pose is correct, but the body pose is not";
  EXPECT_NEAR((wrong.translation() - X_WB.translation()).x(), -0.03, 0.003);
  const double roll_deg = models::RadToDeg(models::TaitBryanFromRotation(wrong.linear()).roll -
                                           models::TaitBryanFromRotation(X_WB.linear()).roll);
  EXPECT_NEAR(roll_deg, -1.0, 0.02);
}

TEST(CalibratedFlight, OverestimatesDistanceWithTooLargeFocalLength) {
  Scenario scenario = ShortHover();
  const double height_m = FirstPose(scenario).translation().z() + 0.05;
  scenario.calibration.camera_model = scenario.camera.model;
  scenario.calibration.camera_model->fx_px *= 1.02;
  scenario.calibration.camera_model->fy_px *= 1.02;
  EXPECT_NEAR((FirstPose(scenario).translation().z() + 0.05) / height_m, 1.02, 0.002);
  EXPECT_NEAR(height_m, 1.0, 0.06);
}

}  // namespace
}  // namespace touchdown::runner
