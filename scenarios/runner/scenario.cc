#include "scenarios/runner/scenario.h"

#include "scenarios/config/camera_info.h"
#include "scenarios/config/config_reader.h"
#include "scenarios/config/config_writer.h"
#include "scenarios/runner/scenario_schema.h"

namespace touchdown::runner {
namespace {

Scenario ReadScenario(const config::ConfigNode& root, const std::string& default_name,
                      std::span<const Override> overrides) {
  Scenario scenario;
  scenario.name = default_name;
  config::OriginByPath origins;
  const auto read = [&](const config::ConfigNode& node) {
    config::ConfigReader reader(node, origins);
    Describe(reader, scenario);
    reader.Finish();
  };
  const auto read_all = [&] {
    read(root);
    for (const Override& change : overrides)
      read(config::ParseOverride(change.assignment, change.place, change.folder));
  };
  read_all();
  // Keys that a calibration leaves out are the truth's, which is known only now.
  scenario.calibration = {};
  read_all();
  config::ConfigChecker checker(origins, root.origin);
  Describe(checker, scenario);
  scenario.expect = scenario.expected_outcome();
  return scenario;
}

/// As reading its own text gives it.
Scenario Resolved(const Scenario& written, const std::string& name) {
  return ReadScenario(config::ParseConfig(ScenarioYaml(written), "resolved " + name, {}), written.name, {});
}

}  // namespace

Outcome Scenario::expected_outcome() const {
  if (expect) return *expect;
  return !script.empty() && script.back().kind == controller::ManoeuvreKind::kLand ? Outcome::kLanded
                                                                                   : Outcome::kHovered;
}

models::Vehicle Scenario::assumed_vehicle() const {
  models::Vehicle assumed = vehicle;
  assumed.camera = calibration.camera.value_or(vehicle.camera);
  assumed.imu = calibration.imu.value_or(vehicle.imu);
  return assumed;
}

Scenario ParseScenario(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       std::span<const Override> overrides) {
  const std::string stem = std::filesystem::path(name).stem().string();
  return Resolved(ReadScenario(config::ParseConfig(text, name, folder), stem, overrides), name);
}

Scenario LoadScenario(const std::filesystem::path& file, std::span<const Override> overrides) {
  return Resolved(ReadScenario(config::ReadConfigFile(file), file.stem().string(), overrides), file.string());
}

std::string ScenarioYaml(const Scenario& scenario) {
  Scenario copy = scenario;
  config::ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

models::CameraModel LoadCameraModel(const std::filesystem::path& file) {
  config::ConfigNode root = config::ReadConfigFile(file);
  return config::ReadAlone<models::CameraModel>(config::IsCameraInfo(root) ? config::CameraModelFromCameraInfo(root)
                                                                           : std::move(root));
}

Calibration LoadCalibration(const std::filesystem::path& file) {
  return config::ReadAlone<Calibration>(config::ReadConfigFile(file));
}

std::string CalibrationYaml(const Calibration& calibration) {
  Calibration copy = calibration;
  config::ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

models::Vehicle LoadVehicle(const std::filesystem::path& file) {
  return config::ReadAlone<models::Vehicle>(config::ReadConfigFile(file));
}

models::LandingPad LoadPad(const std::filesystem::path& file) {
  return config::ReadAlone<models::LandingPad>(config::ReadConfigFile(file));
}

std::string PadYaml(const models::LandingPad& pad) {
  models::LandingPad copy = pad;
  config::ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

}  // namespace touchdown::runner
