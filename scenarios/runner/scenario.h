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
#include "scenarios/runner/logged_sensors.h"
#include "sim/dynamics/hand.h"
#include "sim/dynamics/world.h"
#include "sim/scene/scene.h"
#include "sim/sensors/camera.h"
#include "sim/sensors/imu.h"

namespace touchdown::runner {

/// How a flight ended.
enum class Outcome {
  kLanded,   ///< Motors off after touchdown, at rest on the gear.
  kHovered,  ///< The script ended in the air.
  kGaveUp,   ///< The guidance gave up, or the time limit was reached.
  kCrashed,  ///< A part other than the gear touched something, or the vehicle tipped over or left the room.
  kError,    ///< The simulation failed.
};
inline constexpr std::array<std::string_view, 5> kOutcomeNames = {"landed", "hovered", "gave_up", "crashed", "error"};
constexpr const auto& NamesOf(Outcome) { return kOutcomeNames; }
constexpr std::string_view Name(Outcome outcome) { return kOutcomeNames[static_cast<std::size_t>(outcome)]; }

/// Initial state of the vehicle, at rest.
struct Start {
  bool airborne = false;
  Eigen::Vector3d position_m = Eigen::Vector3d(0.0, 0.0, 1.0);  ///< p_WB. On the ground the height is ignored.
  double yaw_deg = 0.0;
};

/// Bounds of a metric that a flight must meet to pass.
struct Criterion {
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
};

/// Camera and mountings that estimator and controller assume (Sec. III-D). An absent value equals the true one. The
/// values are the result of a calibration, or add a calibration error.
struct Calibration {
  std::optional<models::CameraModel> camera_model;
  std::optional<models::Mounting> camera;
  std::optional<models::Mounting> imu;
};

/// All inputs of a flight and its criteria. scenario_schema.cc describes the keys.
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
  LoggedSensors::Configs sensors;
  sim::SceneConfig scene;
  sim::WorldConfig world;
  Calibration calibration;
  estimator::EstimatorConfig estimator;
  controller::FlightControllerConfig controller;

  Outcome expected_outcome() const;
  /// Camera model that estimator and controller assume: that of the calibration, or the true one.
  models::CameraModel assumed_camera() const { return calibration.camera_model.value_or(camera.model); }
  /// Vehicle that estimator and controller assume: the true one, with the mountings that the calibration defines.
  models::Vehicle assumed_vehicle() const;
  /// Height of the room, which is a cube.
  double ceiling_m() const { return scene.floor_size_m; }
};

/// Override of one key of a scenario file.
struct Override {
  /// Override from the argument of --set: "key=value", with a YAML value.
  Override(const std::string& set) : assignment(set), place("--set " + set) {}  // NOLINT: strings are overrides.
  Override(std::string assignment_text, std::string typed, std::filesystem::path named_from = {})
      : assignment(std::move(assignment_text)), place(std::move(typed)), folder(std::move(named_from)) {}

  std::string assignment;
  std::string place;             ///< Location for messages.
  std::filesystem::path folder;  ///< Base folder of file names in the value.
};

/// Throws InputError for a duration shorter than the frame period of the scenario's camera.
void RequireCameraFrame(const Scenario& scenario, double duration_s);

/// Reads a scenario file and applies overrides in order. Throws InputError with file, line and key for input that
/// docs/scenarios.md does not allow.
///
/// The ScenarioYaml of the result reads back as an identical scenario, so that a flight can be repeated from the
/// scenario.yaml in its output directory.
Scenario LoadScenario(const std::filesystem::path& file, std::span<const Override> overrides = {});

/// Reads a scenario from text. `name` is the file name in messages; `folder` is the base of file names.
Scenario ParseScenario(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       std::span<const Override> overrides = {});

/// YAML of the scenario with all keys, without references to other files.
std::string ScenarioYaml(const Scenario& scenario);

/// Reference of all keys of a scenario, one row each.
std::vector<config::KeyRow> ScenarioReference();

/// Reads a camera calibration from a file: ROS `camera_info` YAML or the keys of `camera.model`. Throws InputError.
models::CameraModel LoadCameraModel(const std::filesystem::path& file);

/// Reads a calibration from a file with the keys of `calibration`. A mounting is complete or absent. Throws InputError.
Calibration LoadCalibration(const std::filesystem::path& file);

/// YAML of a calibration, for LoadCalibration or the key `calibration` of a scenario.
std::string CalibrationYaml(const Calibration& calibration);

/// Reads a vehicle description from a file with the keys of `vehicle`. Throws InputError.
models::Vehicle LoadVehicle(const std::filesystem::path& file);

/// Reads a pad description from a file with the keys of `pad`. Throws InputError.
models::LandingPad LoadPad(const std::filesystem::path& file);

/// YAML of a pad with all keys. LoadPad reads back identical values.
std::string PadYaml(const models::LandingPad& pad);

}  // namespace touchdown::runner
