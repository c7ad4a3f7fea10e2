#include "scenarios/runner/scenario_checks.h"

#include <fmt/format.h>

#include <cmath>

namespace touchdown::runner {
namespace {

/// Throws InputError if the vehicle extends beyond the room at `x_m`, the X or Y of the body origin in W.
void RequireInRoom(const Scenario& s, double x_m) {
  const double limit_m = 0.5 * s.scene.floor_size_m - s.vehicle.arm_m - 0.5 * s.vehicle.rotor.propeller_diameter_m;
  if (std::abs(x_m) > limit_m) {
    throw InputError(fmt::format(
        "{} m is outside the room; allowed with this vehicle and a floor of {} m: -{limit:.3g} to {limit:.3g} m", x_m,
        s.scene.floor_size_m, fmt::arg("limit", limit_m)));
  }
}

/// Throws InputError if the vehicle extends beyond the room at `p_WB`, a position in the air.
void RequireInRoom(const Scenario& s, const Eigen::Vector3d& p_WB) {
  RequireInRoom(s, p_WB.x());
  RequireInRoom(s, p_WB.y());
  if (p_WB.z() < s.vehicle.gear.height_m || p_WB.z() > s.ceiling_m()) {
    throw InputError(fmt::format("the height is {} m; allowed: {} (standing on the floor) to {} m (ceiling)", p_WB.z(),
                                 s.vehicle.gear.height_m, s.ceiling_m()));
  }
}

void CheckPositions(models::ConfigVisitor& v, const Scenario& s) {
  if (s.start.airborne) {
    v.Check("start.position_m", [&s] { RequireInRoom(s, s.start.position_m); });
  } else {
    v.Check("start.x_m", [&s] { RequireInRoom(s, s.start.position_m.x()); });
    v.Check("start.y_m", [&s] { RequireInRoom(s, s.start.position_m.y()); });
  }
  for (std::size_t i = 0; i < s.script.size(); ++i) {
    const controller::Maneuver& m = s.script[i];
    if (m.kind == controller::ManeuverKind::kLand) continue;
    const char* const key = m.kind == controller::ManeuverKind::kTakeoff ? "height_m" : "position_m";
    v.Check(fmt::format("script.{}.{}", i, key), [&] { RequireInRoom(s, m.position_m); });
  }
}

void CheckEvents(models::ConfigVisitor& v, const Scenario& s) {
  for (std::size_t i = 0; i < s.events.size(); ++i) {
    const Event& event = s.events[i];
    v.Check(fmt::format("events.{}.at_s", i), [&] {
      if (event.at_s >= s.time_limit_s) throw InputError("must be below time_limit_s, the flight's end");
    });
    v.Check(fmt::format("events.{}", i), [&] { event.Check(s); });
  }
}

}  // namespace

void RequireCameraFrame(const Scenario& s, double duration_s) {
  if (duration_s * s.camera.rate_hz < 1.0) throw InputError("must not be shorter than the frame period of the camera");
}

void CheckScenario(models::ConfigVisitor& v, const Scenario& s) {
  v.Check("camera.latency_ms", [&s] {
    const double oldest_s = s.camera.latency_s() + 1.0 / s.camera.rate_hz;
    if (oldest_s >= s.controller.vision_fresh_s || s.camera.latency_s() >= s.estimator.filters.attitude.history_s) {
      throw InputError(
          "is too large: the latency plus the frame period must be below controller.vision_fresh_s, and the latency "
          "below attitude_estimator.history_s");
    }
  });
  v.Check("calibration.camera", [&s] { s.assumed_vehicle().Validate(); });
  v.Check("calibration.camera_model", [&s] {
    const models::CameraModel assumed = s.assumed_camera();
    if (assumed.width_px != s.camera.model.width_px || assumed.height_px != s.camera.model.height_px) {
      throw InputError(fmt::format("is for {} x {} px, but the camera has {} x {} px", assumed.width_px,
                                   assumed.height_px, s.camera.model.width_px, s.camera.model.height_px));
    }
  });
  v.Check("scene", [&s] { sim::MakeScene(s.scene, s.pad, s.seed); });
  CheckPositions(v, s);
  CheckEvents(v, s);
  v.Check("hand.carries", [&s] {
    if (s.hand.carries && s.start.airborne)
      throw InputError("cannot be true if start.airborne is true: a hand-held flight starts on the ground");
  });
  v.Check("script", [&s] {
    if (s.hand.carries) return;
    controller::FlightController(s.controller, s.vehicle, s.time, s.imu.rate_hz, s.script, s.start.airborne);
  });
}

}  // namespace touchdown::runner
