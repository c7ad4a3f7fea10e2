#include "scenarios/runner/scenario.h"

#include "scenarios/config/config_reader.h"
#include "scenarios/config/config_writer.h"
#include "scenarios/config/file_format.h"
#include "scenarios/runner/scenario_schema.h"

namespace touchdown::runner {
namespace {

Scenario ReadScenario(const config::ConfigNode& root, const std::string& default_name,
                      std::span<const Override> overrides) {
  std::vector<config::ConfigNode> layers = {root};
  for (const Override& change : overrides) {
    layers.push_back(config::ParseOverride(change.assignment, change.place, change.folder));
  }
  Scenario scenario;
  scenario.name = default_name;
  config::OriginByPath origins;
  for (const config::ConfigNode& layer : layers) {
    config::ConfigReader reader(layer, origins);
    Describe(reader, scenario);
    reader.Finish();
  }
  // Keys that are absent from a calibration default to the true values, which are known only after the last override.
  scenario.calibration = {};
  for (const config::ConfigNode& layer : layers) {
    config::ConfigReader reader(layer, origins);
    DescribeCalibration(reader, scenario);
  }
  config::OriginChecker checker(origins, root.origin);
  Describe(checker, scenario);
  scenario.expect = scenario.expected_outcome();
  return scenario;
}

}  // namespace

Outcome Scenario::expected_outcome() const {
  if (expect) return *expect;
  return !script.empty() && script.back().kind == controller::ManeuverKind::kLand ? Outcome::kLanded
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
  return ReadScenario(config::ParseConfig(text, name, folder), stem, overrides);
}

Scenario LoadScenario(const std::filesystem::path& file, std::span<const Override> overrides) {
  return ReadScenario(config::ReadConfigFile(file), file.stem().string(), overrides);
}

std::string ScenarioYaml(const Scenario& scenario) {
  Scenario copy = scenario;
  config::ConfigWriter writer;
  Describe(writer, copy);
  return writer.yaml();
}

models::CameraModel LoadCameraModel(const std::filesystem::path& file) {
  return config::ReadAlone<models::CameraModel>(
      config::SectionKeys(config::ReadConfigFile(file), models::kCameraModelFile));
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
