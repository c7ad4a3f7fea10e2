#include "scenarios/runner/closed_loop.h"

#include "controller/flight_controller.h"
#include "estimator/make_estimator.h"
#include "scenarios/runner/end_watch.h"
#include "scenarios/runner/event_player.h"
#include "scenarios/runner/flight_recorder.h"
#include "scenarios/runner/sensor_suite.h"
#include "scenarios/runner/vision_timer.h"
#include "scenarios/util/stopwatch.h"
#include "sim/dynamics/hand.h"
#include "sim/dynamics/mujoco_errors.h"
#include "sim/dynamics/world.h"
#include "sim/scene/scene.h"
#include "sim/sensors/camera.h"
#include "sim/sensors/imu.h"

namespace touchdown::runner {
namespace {

Eigen::Matrix3d Upright(double yaw_deg) {
  return models::RotationFromTaitBryan({.roll = 0.0, .pitch = 0.0, .yaw = models::DegToRad(yaw_deg)});
}

Eigen::Isometry3d StartPose(const Start& start, const sim::World& world) {
  if (!start.airborne) {
    return world.RestingPose(start.position_m.x(), start.position_m.y(), models::DegToRad(start.yaw_deg));
  }
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = Upright(start.yaw_deg);
  X_WB.translation() = start.position_m;
  return X_WB;
}

/// Simulates the time at rest before a flight that starts in the air. The vehicle stands on the ground with
/// its initial heading, and the estimator estimates the biases of the IMU.
void SimulateRestBeforeFlight(const Start& start, const models::TimeBase& time, sim::Imu& imu,
                              estimator::StateEstimator& estimator, FlightAudience& audience) {
  constexpr double kTimeAtRest_s = 2.0;
  sim::TrueState truth;
  truth.X_WB.linear() = Upright(start.yaw_deg);
  for (truth.tick = -time.FromSeconds(kTimeAtRest_s); truth.tick < 0; ++truth.tick) {
    const auto sample = imu.Sample(truth);
    if (!sample) continue;
    estimator.AddImu(*sample, true);
    audience.OnImu(*sample, true);
  }
}

}  // namespace

FlightLog FlyClosedLoop(const Scenario& s, FlightObservers observers, const util::StopRequested& stop_requested) {
  sim::World world(s.world, s.vehicle, sim::MakeScene(s.scene, s.pad, s.seed), s.time, s.seed);
  world.Reset(StartPose(s.start, world), s.start.airborne);
  FlightAudience audience(observers);
  audience.OnStart(world);
  sim::Camera camera(s.camera, s.vehicle.X_BC(), world, s.time, s.seed);
  sim::Imu imu(s.imu, s.vehicle.X_BU(), s.time, s.seed, s.world.ground_tilt);
  SensorSuite logged_sensors(s.sensors, world, s.time, s.seed);

  const models::Vehicle assumed = s.assumed_vehicle();
  VisionTimer vision_timer;
  const auto estimator = estimator::MakeEstimator(s.estimator, {.camera = s.assumed_camera(),
                                                                .pad = s.pad,
                                                                .X_BC = assumed.X_BC(),
                                                                .R_BU = assumed.X_BU().linear(),
                                                                .time = s.time,
                                                                .on_stage = vision_timer.listener()});
  if (s.start.airborne) SimulateRestBeforeFlight(s.start, s.time, imu, *estimator, audience);
  std::optional<sim::Hand> hand;
  std::optional<controller::FlightController> controller;
  if (s.hand.carries) {
    hand.emplace(s.hand, world.state().X_WB, s.time, s.seed);
  } else {
    controller.emplace(s.controller, assumed, s.time, s.imu.rate_hz, s.script, s.start.airborne);
  }
  controller::ControlOutput control;

  EventPlayer events(s.events, s.time);
  EndWatch end_watch(s);
  FlightRecorder recorder(s);
  const util::Stopwatch flight_clock;
  const double observers_before_s = audience.seconds();
  const auto finish = [&](const Ending& ending) {
    FlightLog log = recorder.Finish(ending.outcome, ending.reason);
    log.sensors = logged_sensors.TakeRecords();
    log.wall_s = flight_clock.seconds() - (audience.seconds() - observers_before_s);
    return log;
  };

  try {
    for (;;) {
      const sim::TrueState& truth = world.state();
      events.Apply(truth.tick, world);
      recorder.OnTruth(truth, camera.X_WC(truth), events.pad_is_covered(), control.phase);

      if (const auto frame = camera.Sample(truth); frame && !events.frames_are_lost()) {
        vision_timer.Start();
        const estimator::FrameResult result = estimator->AddFrame(frame->image.View(), frame->mid_exposure);
        const FrameRecord& record = recorder.OnFrame(result, camera.render_ms(), vision_timer.Stop());
        audience.OnFrame(*frame, result, record);
      }
      logged_sensors.Sample(truth);

      if (const auto sample = imu.Sample(truth)) {
        const bool at_rest = hand ? hand->IsOnGround(truth.tick) : controller->phase() == controller::Phase::kStandby;
        estimator->AddImu(*sample, at_rest);
        audience.OnImu(*sample, at_rest);
        const models::VehicleEstimate estimate =
            estimator->StateAt(truth.tick).value_or(models::VehicleEstimate{.tick = truth.tick});
        if (controller) {
          control = controller->Update(estimate);
          estimator->AddCommand(truth.tick, control.thrust_n / assumed.mass_kg);
        }
        recorder.OnControl(estimate, control);
        if (stop_requested && stop_requested()) throw util::Interrupted();
      }
      if (const auto ending = end_watch.Judge(truth, control)) return finish(*ending);
      hand ? world.Carry(hand->At(truth.tick + 1)) : world.Step(control.rotors);
    }
  } catch (const sim::SimulationError& error) {
    return finish({Outcome::kError, error.what()});
  }
}

}  // namespace touchdown::runner
