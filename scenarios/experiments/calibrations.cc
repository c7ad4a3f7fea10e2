#include "scenarios/experiments/calibrations.h"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "models/angles.h"
#include "scenarios/laboratory/calibration_bench.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

using models::RadToDeg;

std::string CalibrationId(int seed) { return fmt::format("calibration_{}", seed); }

Json MountingJson(const models::Mounting& mounting) {
  const Eigen::Vector3d& p = mounting.position_m;
  const models::TaitBryanDeg& angles = mounting.misalignment_deg;
  return {{"position_m", {p.x(), p.y(), p.z()}}, {"misalignment_deg", {angles.roll, angles.pitch, angles.yaw}}};
}

models::Mounting MountingFrom(const Json& json) {
  const auto position = json.at("position_m").get<std::array<double, 3>>();
  const auto angles = json.at("misalignment_deg").get<std::array<double, 3>>();
  return {.position_m = {position[0], position[1], position[2]}, .misalignment_deg = {angles[0], angles[1], angles[2]}};
}

Json MeasureCalibrations(int seed, const util::StopRequested& stop_requested) {
  runner::Scenario scenario;
  scenario.seed = static_cast<std::uint64_t>(seed);
  scenario.vehicle = TrueVehicle();
  const laboratory::ImuCalibration imu = laboratory::CalibrateImu(scenario);
  const laboratory::CameraCalibration camera = laboratory::CalibrateCamera(scenario, {}, [&](double) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
  });
  const models::CameraModel& model = camera.fit.model;
  return {{"camera_model",
           {{"width_px", model.width_px},
            {"height_px", model.height_px},
            {"fx_px", model.fx_px},
            {"fy_px", model.fy_px},
            {"cx_px", model.cx_px},
            {"cy_px", model.cy_px},
            {"k1", model.k1},
            {"k2", model.k2}}},
          {"camera", MountingJson(camera.mounting)},
          {"imu", MountingJson(imu.mounting)},
          {"reprojection_px", camera.fit.rms_px},
          {"focal_error_px", camera.focal_error_px},
          {"principal_point_error_px", camera.principal_point_error_px},
          {"position_error_mm", 1e3 * camera.position_error_m},
          {"rotation_error_deg", RadToDeg(camera.rotation_error_rad)},
          {"imu_tilt_error_deg", RadToDeg(imu.tilt_error_rad)}};
}

PaperSection ReportCalibrations(const PaperPlan& plan, const Measured& measured) {
  struct Row {
    const char* label;
    const char* key;
    const char* unit;
    int digits;
  };
  constexpr std::array<Row, 6> kRows = {{{"focal length", "focal_error_px", "px", 3},
                                         {"principal point", "principal_point_error_px", "px", 3},
                                         {"corners off the fit, RMS", "reprojection_px", "px", 3},
                                         {"camera in body: position", "position_error_mm", "mm", 2},
                                         {"camera in body: rotation", "rotation_error_deg", "deg", 3},
                                         {"IMU in body: tilt", "imu_tilt_error_deg", "deg", 3}}};
  PaperSection section{{.id = "calibrations", .title = "Calibrations (Sec. III-D, Eqs. 1 and 2)"}};
  section.paragraphs.push_back(fmt::format(
      "The camera observes a chessboard from 27 poses while the tracking system measures vehicle and board. "
      "The corners give the intrinsics and the pose of the board, and Eq. 2 gives the mounting of the "
      "camera. The mounting of the IMU is the shortest rotation from the gravity measured on level ground "
      "to the vertical of the body. It contains the bias of the accelerometer, and a rotation about the "
      "vertical is not observable. The same vehicle is calibrated {} times; all flights below use the "
      "first calibration.",
      plan.seeds));
  report::ReportTable table{.name = "calibrations",
                            .caption = "Calibration errors relative to the truth.",
                            .head = {"of", "unit", "mean", "worst", "flown with"}};
  for (const Row& row : kRows) {
    std::vector<double> values;
    for (int seed = 1; seed <= plan.seeds; ++seed)
      values.push_back(measured.at(CalibrationId(seed)).at(row.key).get<double>());
    table.rows.push_back({row.label, row.unit, util::Fixed(util::Mean(values), row.digits),
                          util::Fixed(*std::max_element(values.begin(), values.end()), row.digits),
                          util::Fixed(values.front(), row.digits)});
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

models::Vehicle TrueVehicle() {
  models::Vehicle vehicle;
  vehicle.camera = {.position_m = {0.004, -0.003, -0.052},
                    .misalignment_deg = {.roll = 0.6, .pitch = 2.0, .yaw = -0.8}};
  vehicle.imu = {.misalignment_deg = {.roll = 1.5, .pitch = -1.0, .yaw = 2.0}};
  return vehicle;
}

Experiment CalibrationsExperiment(const PaperPlan& plan) {
  constexpr double kCalibration_s = 6.0;
  Experiment experiment;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    experiment.measurements.push_back({.id = CalibrationId(seed),
                                       .expected_s = kCalibration_s,
                                       .measure = [seed](const util::StopRequested& stop_requested) {
                                         return MeasureCalibrations(seed, stop_requested);
                                       }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportCalibrations(plan, measured); };
  return experiment;
}

runner::Calibration CalibrationOf(const Measured& measured) {
  const Json& result = measured.at(CalibrationId(1));
  const Json& json = result.at("camera_model");
  models::CameraModel model;
  model.width_px = json.at("width_px").get<int>();
  model.height_px = json.at("height_px").get<int>();
  model.fx_px = json.at("fx_px").get<double>();
  model.fy_px = json.at("fy_px").get<double>();
  model.cx_px = json.at("cx_px").get<double>();
  model.cy_px = json.at("cy_px").get<double>();
  model.k1 = json.at("k1").get<double>();
  model.k2 = json.at("k2").get<double>();
  return {.camera_model = model, .camera = MountingFrom(result.at("camera")), .imu = MountingFrom(result.at("imu"))};
}

}  // namespace touchdown::experiments
