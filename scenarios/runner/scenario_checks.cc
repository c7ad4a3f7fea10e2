#include "scenarios/runner/scenario_checks.h"

#include <fmt/format.h>

#include <cmath>

namespace touchdown::runner {
namespace {

/// Throws InputError for a place along X or Y of the body's origin at which the vehicle reaches out of the room.
void RequireInRoom(const Scenario& s, double x_m) {
  const double farthest_m = 0.5 * s.scene.floor_size_m - s.vehicle.arm_m - 0.5 * s.vehicle.rotor.propeller_diameter_m;
  if (std::abs(x_m) > farthest_m) {
    throw InputError(
        fmt::format("{} m lies outside the room: a vehicle of this size and a floor of {} m allow {:.3g} m", x_m,
                    s.scene.floor_size_m, farthest_m));
  }
}

/// Same for a position in the air.
void RequireInRoom(const Scenario& s, const Eigen::Vector3d& p_WB) {
  RequireInRoom(s, p_WB.x());
  RequireInRoom(s, p_WB.y());
  if (p_WB.z() < s.vehicle.gear.height_m || p_WB.z() > s.ceiling_m()) {
    throw InputError(
        fmt::format("a height of {} m is not between the floor (with the gear below, {} m) and the ceiling ({} m)",
                    p_WB.z(), s.vehicle.gear.height_m, s.ceiling_m()));
  }
}

void CheckPlaces(models::ConfigVisitor& v, const Scenario& s) {
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
  if (duration_s * s.camera.rate_hz < 1.0) throw InputError("lasts less than a camera frame's period");
}

void CheckScenario(models::ConfigVisitor& v, const Scenario& s) {
  v.Check("camera.latency_ms", [&s] {
    const double oldest_s = s.camera.latency_s() + 1.0 / s.camera.rate_hz;
    if (oldest_s >= s.controller.vision_fresh_s || s.camera.latency_s() >= s.estimator.filters.attitude.history_s) {
      throw InputError(
          "with a frame's period on top must stay below controller.vision_fresh_s, and below "
          "attitude_estimator.history_s: the frames would come too late to be used");
    }
  });
  v.Check("calibration.camera", [&s] { s.assumed_vehicle().Validate(); });
  v.Check("calibration.camera_model", [&s] {
    const models::CameraModel assumed = s.assumed_camera();
    if (assumed.width_px != s.camera.model.width_px || assumed.height_px != s.camera.model.height_px) {
      throw InputError(fmt::format("is for {} x {} px, but the camera's images have {} x {} px", assumed.width_px,
                                   assumed.height_px, s.camera.model.width_px, s.camera.model.height_px));
    }
  });
  v.Check("scene", [&s] { sim::MakeScene(s.scene, s.pad, s.seed); });
  CheckPlaces(v, s);
  CheckEvents(v, s);
  v.Check("hand.carries", [&s] {
    if (s.hand.carries && s.start.airborne) throw InputError("the vehicle starts on its feet: start.airborne is true");
  });
  v.Check("script", [&s] {
    if (s.hand.carries) return;
    controller::FlightController(s.controller, s.vehicle, s.time, s.imu.rate_hz, s.script, s.start.airborne);
  });
}

}  // namespace touchdown::runner
