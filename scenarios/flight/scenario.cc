#include "scenarios/flight/scenario.h"

#include "scenarios/flight/camera_info.h"
#include "scenarios/flight/config_reader.h"
#include "scenarios/flight/config_writer.h"
#include "scenarios/flight/scenario_schema.h"

namespace touchdown::scenarios {
namespace {

Scenario ReadScenario(const ConfigNode& root, const std::string& default_name, std::span<const Override> overrides) {
  Scenario scenario;
  scenario.name = default_name;
  OriginByPath origins;
  const auto read = [&](const ConfigNode& node) {
    ConfigReader reader(node, origins);
    Describe(reader, scenario);
    reader.Finish();
  };
  const auto read_all = [&] {
    read(root);
    for (const Override& change : overrides) read(ParseOverride(change.assignment, change.place, change.folder));
  };
  read_all();
  // Keys that a calibration leaves out are the truth's, which is known only now.
  scenario.calibration = {};
  read_all();
  ConfigChecker checker(origins, root.origin);
  Describe(checker, scenario);
  scenario.expect = scenario.expected_outcome();
  return scenario;
}

/// As reading its own text gives it.
Scenario Resolved(const Scenario& written, const std::string& name) {
  return ReadScenario(ParseConfig(ScenarioYaml(written), "resolved " + name, {}), written.name, {});
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
  return Resolved(ReadScenario(ParseConfig(text, name, folder), stem, overrides), name);
}

Scenario LoadScenario(const std::filesystem::path& file, std::span<const Override> overrides) {
  return Resolved(ReadScenario(ReadConfigFile(file), file.stem().string(), overrides), file.string());
}

std::string ScenarioYaml(const Scenario& scenario) {
  Scenario copy = scenario;
  ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

models::CameraModel LoadCameraModel(const std::filesystem::path& file) {
  ConfigNode root = ReadConfigFile(file);
  return ReadAlone<models::CameraModel>(IsCameraInfo(root) ? CameraModelFromCameraInfo(root) : std::move(root));
}

Calibration LoadCalibration(const std::filesystem::path& file) { return ReadAlone<Calibration>(ReadConfigFile(file)); }

std::string CalibrationYaml(const Calibration& calibration) {
  Calibration copy = calibration;
  ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

models::Vehicle LoadVehicle(const std::filesystem::path& file) {
  return ReadAlone<models::Vehicle>(ReadConfigFile(file));
}

models::LandingPad LoadPad(const std::filesystem::path& file) {
  return ReadAlone<models::LandingPad>(ReadConfigFile(file));
}

std::string PadYaml(const models::LandingPad& pad) {
  models::LandingPad copy = pad;
  ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

}  // namespace touchdown::scenarios
