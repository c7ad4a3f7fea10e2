#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/flight_controller.h"
#include "controller/guidance.h"
#include "estimator/attitude_estimator.h"
#include "estimator/make_estimator.h"
#include "estimator/pose_filter.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/time.h"
#include "models/vehicle.h"
#include "scenarios/config/config_reference.h"
#include "scenarios/runner/events/event.h"
#include "sim/dynamics/hand.h"
#include "sim/dynamics/world.h"
#include "sim/scene/scene.h"
#include "sim/sensors/camera.h"
#include "sim/sensors/imu.h"
#include "sim/sensors/tracking_system.h"

namespace touchdown::runner {

/// How a flight ended.
enum class Outcome {
  kLanded,   ///< Motors off after touchdown, at rest on the gear.
  kHovered,  ///< The script came to its end in the air.
  kGaveUp,   ///< Control was handed over, or the time limit passed.
  kCrashed,  ///< Something but the gear touched something, the vehicle tipped over, or it left the room.
  kError,    ///< The simulation went wrong.
};
inline constexpr std::array<std::string_view, 5> kOutcomeNames = {"landed", "hovered", "gave_up", "crashed", "error"};
constexpr const auto& NamesOf(Outcome) { return kOutcomeNames; }
constexpr std::string_view Name(Outcome outcome) { return kOutcomeNames[static_cast<std::size_t>(outcome)]; }

/// Where the vehicle is at tick 0, at rest.
struct Start {
  bool airborne = false;
  Eigen::Vector3d position_m = Eigen::Vector3d(0.0, 0.0, 1.0);  ///< p_WB; on the ground, the height is not used.
  double yaw_deg = 0.0;
};

/// A bound on a metric, which the flight must keep to pass.
struct Criterion {
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
};

/// Camera and mountings as estimator and controller assume them (Sec. III-D), where they differ from the truth: the
/// result of a calibration, or an error of one.
struct Calibration {
  std::optional<models::CameraModel> camera_model;
  std::optional<models::Mounting> camera;
  std::optional<models::Mounting> imu;
};

/// Everything that decides how a flight goes and how it is judged. scenario_schema.cc describes the keys.
struct Scenario {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  double time_limit_s = 120.0;
  std::optional<Outcome> expect;
  Start start;
  sim::HandConfig hand;
  std::vector<controller::Maneuver> script;
  std::vector<Event> events;
  std::vector<Criterion> criteria;

  models::TimeBase time;
  models::Vehicle vehicle;
  models::LandingPad pad;
  sim::CameraConfig camera;
  sim::ImuConfig imu;
  sim::TrackingSystemConfig tracking;
  sim::SceneConfig scene;
  sim::WorldConfig world;
  Calibration calibration;
  estimator::EstimatorConfig estimator;
  controller::FlightControllerConfig controller;

  Outcome expected_outcome() const;
  /// Camera model that estimator and controller assume: the calibration's, or the true one.
  models::CameraModel assumed_camera() const { return calibration.camera_model.value_or(camera.model); }
  /// Vehicle that estimator and controller assume: the true one with the mountings of the calibration, where given.
  models::Vehicle assumed_vehicle() const;
  /// Height at which the room ends: it is a cube.
  double ceiling_m() const { return scene.floor_size_m; }
};

/// A change of one key over what a scenario's file says.
struct Override {
  /// As --set is given it: "key=value", the value as YAML.
  Override(const std::string& set) : assignment(set), place("--set " + set) {}  // NOLINT: strings are overrides.
  Override(std::string assignment_text, std::string typed, std::filesystem::path named_from = {})
      : assignment(std::move(assignment_text)), place(std::move(typed)), folder(std::move(named_from)) {}

  std::string assignment;
  std::string place;             ///< What messages call it.
  std::filesystem::path folder;  ///< That names of files within it are meant from.
};

/// Throws InputError for a duration in which no frame of the scenario's camera is due.
void RequireCameraFrame(const Scenario& scenario, double duration_s);

/// Reads a scenario's file and applies overrides over it, in their order. Throws InputError, naming file,
/// line and key, for anything that is not as docs/scenarios.md has it.
///
/// Reading the ScenarioYaml of the result gives the same scenario, to the last bit, so that a flight can be flown again
/// from the scenario.yaml beside its results.
Scenario LoadScenario(const std::filesystem::path& file, std::span<const Override> overrides = {});

/// The same of text; `name` stands for the file in messages, and files are looked for in `folder`.
Scenario ParseScenario(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       std::span<const Override> overrides = {});

/// The whole scenario as YAML with every key, in place.
std::string ScenarioYaml(const Scenario& scenario);

/// One row for each key that a scenario may hold.
std::vector<config::KeyRow> ScenarioReference();

/// A camera's calibration from a file: ROS `camera_info` YAML or the keys of `camera.model`. Throws InputError.
models::CameraModel LoadCameraModel(const std::filesystem::path& file);

/// A calibration from a file with the keys of `calibration`, in which a mounting is given whole or not at all. Throws
/// InputError.
Calibration LoadCalibration(const std::filesystem::path& file);

/// A calibration as YAML, which LoadCalibration and a scenario's `calibration` read back.
std::string CalibrationYaml(const Calibration& calibration);

/// A vehicle's description from a file with the keys of `vehicle`. Throws InputError.
models::Vehicle LoadVehicle(const std::filesystem::path& file);

/// A pad's description from a file with the keys of `pad`. Throws InputError.
models::LandingPad LoadPad(const std::filesystem::path& file);

/// A pad as YAML with every key, which LoadPad reads back to the last bit.
std::string PadYaml(const models::LandingPad& pad);

}  // namespace touchdown::runner
