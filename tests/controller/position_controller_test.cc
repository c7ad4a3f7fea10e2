#include "controller/position_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "controller/attitude_controller.h"
#include "controller/mixer.h"
#include "models/error.h"
#include "tests/support/nominal.h"
#include "tests/support/quadrotor_ode.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using models::TaitBryan;
using Motion = models::VehicleEstimate::Motion;
using Target = PositionController::Target;
using tests::kPeriod_s;
using tests::kVehicle;
using tests::kWeight_n;

PositionController Fresh() { return {PositionControllerConfig{}, kVehicle, kPeriod_s}; }

PositionController::Demand DemandFor(const Vector3d& error, double yaw = 0.0) {
  return Fresh().Update({.p_m = error}, Motion{}, {.yaw = yaw});
}

TEST(PositionController, CommandsWeightWithoutTiltAtSetPoint) {
  const PositionController::Demand demand = DemandFor(Vector3d::Zero());
  EXPECT_DOUBLE_EQ(demand.thrust_n, kWeight_n);
  EXPECT_DOUBLE_EQ(demand.roll, 0.0);
  EXPECT_DOUBLE_EQ(demand.pitch, 0.0);
}

TEST(PositionController, TiltsTowardsSetPoint) {
  EXPECT_GT(DemandFor({0.2, 0.0, 0.0}).pitch, 0.0);  // Nose down: forward.
  EXPECT_LT(DemandFor({0.0, 0.2, 0.0}).roll, 0.0);   // Left side down: to the left.
  EXPECT_GT(DemandFor({0.0, 0.0, 0.2}).thrust_n, kWeight_n);
  EXPECT_LT(DemandFor({0.0, 0.0, -0.2}).thrust_n, kWeight_n);
}

TEST(PositionController, KeepsThrustDirectionInWorldAtEveryYaw) {
  const Vector3d error(0.2, -0.1, 0.05);
  const auto force = [&](double yaw) -> Vector3d {
    const PositionController::Demand demand = DemandFor(error, yaw);
    return models::RotationFromTaitBryan({.roll = demand.roll, .pitch = demand.pitch, .yaw = yaw}).col(2);
  };
  for (const double yaw_deg : {-170.0, -90.0, -20.0, 45.0, 90.0, 180.0}) {
    EXPECT_NEAR((force(DegToRad(yaw_deg)) - force(0.0)).norm(), 0.0, 1e-12) << yaw_deg;
  }
}

TEST(PositionController, RespectsTiltAndAccelerationLimits) {
  const PositionControllerConfig config;
  for (const double z : {-50.0, 0.0, 50.0}) {
    PositionController controller = Fresh();
    const auto demand = controller.Update({.p_m = {100.0, 100.0, z}, .v_m_s = {20.0, 20.0, z}}, Motion{}, {});
    const Eigen::Matrix3d R = models::RotationFromTaitBryan({.roll = demand.roll, .pitch = demand.pitch});
    EXPECT_LE(std::acos(R(2, 2)), DegToRad(config.max_tilt_deg) + 1e-9);
    EXPECT_NEAR(
        demand.thrust_n,
        kVehicle.mass_kg * (9.81 + std::clamp(z, -config.max_z_acceleration_m_s2, config.max_z_acceleration_m_s2)),
        1e-9);
  }
}

TEST(PositionController, CompensatesCurrentTilt) {
  PositionController controller = Fresh();
  const auto level = controller.Update({}, Motion{}, {});
  const auto tilted = controller.Update({}, Motion{}, {.roll = DegToRad(20.0)});
  EXPECT_NEAR(tilted.thrust_n * std::cos(DegToRad(20.0)), level.thrust_n, 1e-9);
}

TEST(PositionController, DoesNotWindUpAtLimit) {
  PositionController tilting = Fresh();
  for (int i = 0; i < 2000; ++i) {
    tilting.Update({.p_m = {0.0, 0.0, 0.0}, .v_m_s = {5.0, 0.0, 0.0}}, Motion{}, {});
    tilting.Integrate(kWeight_n);
  }
  EXPECT_DOUBLE_EQ(tilting.trim_m_s2().x(), 0.0);

  PositionController lifting = Fresh();
  for (int i = 0; i < 2000; ++i) {
    const auto demand = lifting.Update({.p_m = {0.0, 0.0, 0.1}}, Motion{}, {});
    lifting.Integrate(demand.thrust_n - 0.5);
  }
  EXPECT_DOUBLE_EQ(lifting.trim_m_s2().z(), 0.0);
}

TEST(PositionController, BoundsTrim) {
  const PositionControllerConfig config;
  PositionController controller = Fresh();
  for (int i = 0; i < 20000; ++i) {
    const auto demand = controller.Update({.p_m = {0.3, 0.4, 0.05}}, Motion{}, {});
    controller.Integrate(demand.thrust_n);
  }
  EXPECT_NEAR(controller.trim_m_s2().head<2>().norm(), config.max_xy_integral_m_s2, 1e-9);
  EXPECT_NEAR(controller.trim_m_s2().z(), config.max_z_integral_m_s2, 1e-9);
}

TEST(PositionController, UsesStandingTiltAsTrim) {
  PositionController controller = Fresh();
  const TaitBryan stance{.roll = 0.02, .pitch = -0.03, .yaw = 0.4};
  controller.SetTrimFromStance(stance);
  const auto demand = controller.Trimmed({.yaw = stance.yaw});
  EXPECT_NEAR(demand.roll, stance.roll, 1e-4);
  EXPECT_NEAR(demand.pitch, stance.pitch, 1e-4);
}

struct PositionFlight {
  models::Vehicle truth;
  Vector3d wind_m_s = Vector3d::Zero();
  TaitBryan level_error = {};
  Vector3d start_m{0.0, 0.0, 1.0};
  Vector3d target_m{0.0, 0.0, 1.0};
};

/// Simulates both loops with the rigid body, the true position, and an attitude with the error level_error.
void FlyPosition(const PositionFlight& flight, double duration_s,
                 const std::function<void(double, const Vector3d&)>& observe) {
  tests::QuadrotorOde truth(flight.truth);
  truth.StartRotorsAtHover();
  truth.wind = flight.wind_m_s;
  truth.state.p = flight.start_m;
  PositionController position = Fresh();
  AttitudeController attitude({}, kVehicle, kPeriod_s);
  const Mixer mixer(kVehicle);
  for (int i = 0; i * kPeriod_s < duration_s; ++i) {
    TaitBryan angles = models::TaitBryanFromRotation(truth.state.R);
    angles.roll += flight.level_error.roll;
    angles.pitch += flight.level_error.pitch;
    const auto demand =
        position.Update({.p_m = flight.target_m}, {.p_WB = truth.state.p, .v_WB = truth.state.v}, angles);
    const Vector3d torque =
        attitude.Torque({.roll = demand.roll, .pitch = demand.pitch, .yaw = 0.0}, angles, truth.state.w);
    const Mixer::Result mixed = mixer.Mix({demand.thrust_n, torque});
    attitude.Integrate(mixed.achieved.torque_n_m);
    position.Integrate(mixed.achieved.thrust_n);
    for (int tick = 0; tick < 6; ++tick) truth.Step(mixed.rotors, kPeriod_s / 6);
    observe((i + 1) * kPeriod_s, truth.state.p);
  }
}

TEST(PositionLoop, TracksSetPointStepWithSmallOvershoot) {
  Vector3d peak = Vector3d::Zero(), last;
  FlyPosition({.truth = kVehicle, .target_m = {0.5, -0.3, 1.4}}, 6.0, [&](double, const Vector3d& p) {
    peak = peak.cwiseMax(Vector3d(p.x(), -p.y(), p.z() - 1.0));
    last = p;
  });
  EXPECT_NEAR((last - Vector3d(0.5, -0.3, 1.4)).norm(), 0.0, 0.02);
  EXPECT_LT(peak.x(), 0.5 * 1.2);
  EXPECT_LT(peak.y(), 0.3 * 1.2);
  EXPECT_LT(peak.z(), 0.4 * 1.2);
}

TEST(PositionLoop, IntegratesTrimAgainstWind) {
  double farthest = 0.0;
  Vector3d last;
  FlyPosition({.truth = kVehicle, .wind_m_s = {3.0, 0.0, 0.0}}, 12.0, [&](double, const Vector3d& p) {
    farthest = std::max(farthest, p.head<2>().norm());
    last = p;
  });
  EXPECT_LT(farthest, 0.35);
  EXPECT_LT(last.head<2>().norm(), 0.02);
}

TEST(PositionLoop, IntegratesTrimAgainstLevelAndMassErrors) {
  models::Vehicle heavy = kVehicle;
  heavy.mass_kg *= 1.05;
  Vector3d last;
  FlyPosition({.truth = heavy, .level_error = {.roll = DegToRad(1.2), .pitch = DegToRad(-1.2)}}, 12.0,
              [&](double, const Vector3d& p) { last = p; });
  EXPECT_LT((last - Vector3d(0.0, 0.0, 1.0)).norm(), 0.02);
}

TEST(PositionControllerConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(PositionControllerConfig{}.Validate());
  PositionControllerConfig upside_down;
  upside_down.max_tilt_deg = 90.0;
  EXPECT_THROW(upside_down.Validate(), InputError);
  PositionControllerConfig falling;
  falling.max_z_acceleration_m_s2 = 10.0;
  EXPECT_THROW(falling.Validate(), InputError);
  PositionControllerConfig nan;
  nan.xy_velocity_gain_1_s = NAN;
  EXPECT_THROW(nan.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::controller
