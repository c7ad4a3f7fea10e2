#include "controller/attitude_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>

#include "controller/mixer.h"
#include "models/error.h"
#include "tests/support/nominal.h"
#include "tests/support/quadrotor_ode.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using models::TaitBryan;
using tests::kPeriod_s;
using tests::kVehicle;

struct LoopConfig {
  models::Vehicle truth;
  int delay_periods = 0;                        ///< Delay of the attitude and rate inputs of the controller.
  Vector3d disturbance_n_m = Vector3d::Zero();  ///< Constant torque of an off-center load.
  double thrust_n = kVehicle.mass_kg * models::kGravity_m_s2;
};

/// Flies the attitude loop on the rigid body for `duration_s` and calls `observe` every period.
void FlyAttitude(const LoopConfig& config, const TaitBryan& start, const TaitBryan& set_point, double duration_s,
                 const std::function<void(double, const TaitBryan&, const Vector3d&)>& observe) {
  tests::QuadrotorOde truth(config.truth);
  truth.StartRotorsAtHover();
  truth.state.p.z() = 10.0;
  truth.state.R = models::RotationFromTaitBryan(start);
  AttitudeController controller({}, kVehicle, kPeriod_s);
  const Mixer mixer(kVehicle);
  struct Seen {
    TaitBryan attitude;
    Vector3d rate;
  };
  std::deque<Seen> seen;
  for (int i = 0; i * kPeriod_s < duration_s; ++i) {
    seen.push_back({models::TaitBryanFromRotation(truth.state.R), truth.state.w});
    if (static_cast<int>(seen.size()) > config.delay_periods + 1) seen.pop_front();
    const Vector3d torque = controller.Torque(set_point, seen.front().attitude, seen.front().rate);
    const Mixer::Result mixed = mixer.Mix({config.thrust_n, torque});
    controller.Integrate(mixed.achieved.torque_n_m);
    for (int tick = 0; tick < 6; ++tick) {
      truth.state.w += config.disturbance_n_m.cwiseQuotient(config.truth.inertia_kg_m2) * kPeriod_s / 6;
      truth.Step(mixed.rotors, kPeriod_s / 6);
    }
    observe((i + 1) * kPeriod_s, models::TaitBryanFromRotation(truth.state.R), truth.state.w);
  }
}

TEST(AttitudeLoop, TracksRollStepWithSmallOvershoot) {
  const double step = DegToRad(10.0);
  double rise_s = 0.0, peak = 0.0, last = 0.0;
  FlyAttitude({}, {}, {.roll = step}, 2.0, [&](double t, const TaitBryan& attitude, const Vector3d&) {
    if (rise_s == 0.0 && attitude.roll > 0.9 * step) rise_s = t;
    peak = std::max(peak, attitude.roll);
    last = attitude.roll;
  });
  EXPECT_GT(rise_s, 0.0);
  EXPECT_LT(rise_s, 0.40);
  EXPECT_LT(peak, 1.15 * step);
  EXPECT_NEAR(last, step, 0.02 * step);
}

TEST(AttitudeLoop, IsDampedWithLargerDelayAndRotorLag) {
  LoopConfig config;
  config.delay_periods = 2;
  config.truth.rotor.time_constant_s = 0.06;
  double late = 0.0;
  FlyAttitude(config, {.roll = DegToRad(10.0), .pitch = DegToRad(-10.0)}, {}, 3.0,
              [&](double t, const TaitBryan& attitude, const Vector3d&) {
                if (t > 1.5) late = std::max({late, std::abs(attitude.roll), std::abs(attitude.pitch)});
              });
  EXPECT_LT(late, DegToRad(0.5));
}

TEST(AttitudeLoop, LimitsYawRateAndStaysLevel) {
  double fastest = 0.0, tilt = 0.0, last = 0.0;
  FlyAttitude({}, {.yaw = DegToRad(120.0)}, {}, 8.0, [&](double, const TaitBryan& attitude, const Vector3d& w) {
    fastest = std::max(fastest, std::abs(w.z()));
    tilt = std::max({tilt, std::abs(attitude.roll), std::abs(attitude.pitch)});
    last = attitude.yaw;
  });
  EXPECT_NEAR(fastest, DegToRad(AttitudeControllerConfig{}.max_yaw_rate_deg_s), 0.15);
  EXPECT_LT(tilt, DegToRad(1.0));
  EXPECT_NEAR(last, 0.0, DegToRad(1.0));
}

TEST(AttitudeLoop, UsesShortestYawRotation) {
  double smallest = DegToRad(170.0);
  FlyAttitude({}, {.yaw = DegToRad(170.0)}, {.yaw = DegToRad(-170.0)}, 2.0,
              [&](double, const TaitBryan& attitude, const Vector3d&) {
                smallest = std::min(smallest, std::abs(attitude.yaw));
              });
  EXPECT_GT(smallest, DegToRad(165.0));
}

TEST(AttitudeLoop, CompensatesConstantTorque) {
  LoopConfig config;
  config.disturbance_n_m = {0.03, -0.02, 0.005};
  TaitBryan last;
  FlyAttitude(config, {}, {}, 6.0, [&](double, const TaitBryan& attitude, const Vector3d&) { last = attitude; });
  EXPECT_NEAR(last.roll, 0.0, DegToRad(0.1));
  EXPECT_NEAR(last.pitch, 0.0, DegToRad(0.1));
  EXPECT_NEAR(last.yaw, 0.0, DegToRad(1.0));
}

TEST(AttitudeController, CommandsAngularAccelerationIndependentOfInertia) {
  models::Vehicle heavy = kVehicle;
  heavy.inertia_kg_m2 *= 3.0;
  const TaitBryan set_point{.roll = 0.1, .pitch = -0.05, .yaw = 0.2};
  const Vector3d light_torque = AttitudeController({}, kVehicle, kPeriod_s).Torque(set_point, {}, Vector3d::Zero());
  const Vector3d heavy_torque = AttitudeController({}, heavy, kPeriod_s).Torque(set_point, {}, Vector3d::Zero());
  EXPECT_NEAR((3.0 * light_torque - heavy_torque).norm(), 0.0, 1e-12);
  EXPECT_GT(light_torque.x(), 0.0);
  EXPECT_LT(light_torque.y(), 0.0);
  EXPECT_GT(light_torque.z(), 0.0);
}

TEST(AttitudeController, DoesNotWindUpOnSaturatedAxis) {
  AttitudeController saturated({}, kVehicle, kPeriod_s), free({}, kVehicle, kPeriod_s);
  const TaitBryan set_point{.roll = 0.3};
  for (int i = 0; i < 400; ++i) {
    const Vector3d asked = saturated.Torque(set_point, {}, Vector3d::Zero());
    saturated.Integrate(0.5 * asked);
    free.Integrate(free.Torque(set_point, {}, Vector3d::Zero()));
  }
  const Vector3d fresh = AttitudeController({}, kVehicle, kPeriod_s).Torque({}, {}, Vector3d::Zero());
  EXPECT_NEAR((saturated.Torque({}, {}, Vector3d::Zero()) - fresh).norm(), 0.0, 1e-12);
  const double limit = AttitudeControllerConfig{}.max_roll_pitch_integral_rad_s2 * kVehicle.inertia_kg_m2.x();
  EXPECT_NEAR(free.Torque({}, {}, Vector3d::Zero()).x(), limit, 1e-9);
}

TEST(AttitudeController, UnwindsWhileSaturated) {
  AttitudeController controller({}, kVehicle, kPeriod_s);
  for (int i = 0; i < 400; ++i) controller.Integrate(controller.Torque({.roll = 0.3}, {}, Vector3d::Zero()));
  const double wound = controller.Torque({}, {}, Vector3d::Zero()).x();
  for (int i = 0; i < 20; ++i) {
    const Vector3d asked = controller.Torque({.roll = -0.05}, {}, Vector3d::Zero());
    controller.Integrate(asked - Vector3d(0.01, 0.0, 0.0));
  }
  EXPECT_LT(controller.Torque({}, {}, Vector3d::Zero()).x(), wound);
}

TEST(AttitudeController, ClearsStateOnReset) {
  AttitudeController controller({}, kVehicle, kPeriod_s);
  for (int i = 0; i < 50; ++i) controller.Integrate(controller.Torque({.roll = 0.3}, {}, Vector3d(0.1, 0.0, 0.0)));
  controller.Reset();
  EXPECT_EQ(controller.Torque({}, {}, Vector3d::Zero()), Vector3d::Zero());
}

TEST(AttitudeControllerConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(AttitudeControllerConfig{}.Validate());
  AttitudeControllerConfig negative;
  negative.yaw_rate_gain_1_s = -1.0;
  EXPECT_THROW(negative.Validate(), InputError);
  AttitudeControllerConfig nothing;
  nothing.derivative_cutoff_hz = 0.0;
  EXPECT_THROW(nothing.Validate(), InputError);
  AttitudeControllerConfig endless;
  endless.max_yaw_rate_deg_s = INFINITY;
  EXPECT_THROW(endless.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::controller
