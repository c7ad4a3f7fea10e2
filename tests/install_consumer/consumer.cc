// Program of a vehicle with the flight libraries. The state estimator receives IMU samples and camera frames, the
// controller receives the estimate, and the motors receive the commands of the controller. In this test the vehicle is
// on the ground before takeoff, and the image is blank.
#include <cstdio>
#include <string>

#include <touchdown/controller/flight_controller.h>
#include <touchdown/controller/mixer.h>
#include <touchdown/estimator/make_estimator.h>
#include <touchdown/models/vehicle.h>

#include "controller/mixer.h"

using touchdown::controller::Phase;

int main() {
  const touchdown::models::Vehicle vehicle;
  const touchdown::controller::Mixer mixer(vehicle);
  const consumer::Mixer motors(vehicle.rotor.max_speed_rad_s);
  const touchdown::models::TimeBase time;
  constexpr int kImu_hz = 200, kCamera_hz = 50;
  const touchdown::models::Tick imu_period = time.PeriodOf(kImu_hz), camera_period = time.PeriodOf(kCamera_hz);

  touchdown::estimator::EstimatorSetup setup;
  setup.X_BC = vehicle.X_BC();
  setup.R_BU = vehicle.X_BU().linear();
  const auto estimator = touchdown::estimator::MakeEstimator({}, setup);
  touchdown::controller::FlightController controller({}, vehicle, time, kImu_hz,
                                                     {{.kind = touchdown::controller::ManeuverKind::kTakeoff}}, false);

  const touchdown::models::Image blank(setup.camera.width_px, setup.camera.height_px, 200);
  const Eigen::Vector3d at_rest(0.0, 0.0, touchdown::models::kGravity_m_s2);
  touchdown::estimator::FrameResult result;
  touchdown::controller::ControlOutput control;
  for (touchdown::models::Tick tick = 0; tick < time.FromSeconds(0.5); tick += imu_period) {
    if (tick % camera_period == 0) result = estimator->AddFrame(blank.View(), tick);
    estimator->AddImu({tick, at_rest, Eigen::Vector3d::Zero()}, controller.phase() == Phase::kStandby);
    control = controller.Update(estimator->StateAt(tick).value());
    estimator->AddCommand(tick, control.thrust_n / vehicle.mass_kg);
  }
  std::printf("%s (%s), %s\n", std::string(Name(result.status)).c_str(), result.reason.c_str(),
              std::string(Name(control.phase)).c_str());
  const bool is_standing = control.phase == Phase::kStandby && motors.Fractions(control.rotors.speed_rad_s)[0] == 0.0 &&
                           mixer.WrenchOf(control.rotors).thrust_n == 0.0;
  return is_standing && result.reason == "no_component" ? 0 : 1;
}
