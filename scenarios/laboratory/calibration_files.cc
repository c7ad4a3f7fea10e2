#include "scenarios/laboratory/calibration_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "models/angles.h"
#include "scenarios/util/platform.h"
#include "scenarios/util/version.h"

namespace touchdown::laboratory {
namespace {

using Json = nlohmann::ordered_json;
using models::RadToDeg;

Json Xyz(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json AnglesJson(const models::TaitBryanDeg& angles) { return {angles.roll, angles.pitch, angles.yaw}; }

Json MountingJson(const models::Mounting& mounting) {
  return {{"position_m", Xyz(mounting.position_m)}, {"misalignment_deg", AnglesJson(mounting.misalignment_deg)}};
}

Json ModelJson(const models::CameraModel& c) {
  return {{"fx_px", c.fx_px}, {"fy_px", c.fy_px}, {"cx_px", c.cx_px}, {"cy_px", c.cy_px}, {"k1", c.k1},
          {"k2", c.k2},       {"p1", c.p1},       {"p2", c.p2},       {"k3", c.k3}};
}

Json ImuJson(const ImuCalibration& imu, const std::optional<runner::Scenario>& scenario) {
  Json json{{"samples", imu.estimate.samples},
            {"found", {{"misalignment_deg", AnglesJson(imu.mounting.misalignment_deg)}}},
            {"noise_sigma_deg", RadToDeg(imu.estimate.noise_sigma_rad)},
            {"not_observable", "yaw"}};
  if (!scenario) return json;
  json["true"] = {{"misalignment_deg", AnglesJson(scenario->vehicle.imu.misalignment_deg)}};
  json["error"] = {{"tilt_deg", RadToDeg(imu.tilt_error_rad)}};
  return json;
}

Json CameraJson(const CameraCalibration& camera, const runner::Scenario& scenario) {
  return {
      {"views", camera.views.size()},
      {"views_used", camera.views_used()},
      {"reprojection_rms_px", camera.fit.rms_px},
      {"found", {{"camera_model", ModelJson(camera.fit.model)}, {"camera", MountingJson(camera.mounting)}}},
      {"sigma",
       {{"position_m", Xyz(camera.X_BC.position_sigma_m())},
        {"rotation_deg", Xyz(camera.X_BC.rotation_sigma_rad() * RadToDeg(1.0))}}},
      {"true", {{"camera_model", ModelJson(scenario.camera.model)}, {"camera", MountingJson(scenario.vehicle.camera)}}},
      {"error",
       {{"focal_px", camera.focal_error_px},
        {"principal_point_px", camera.principal_point_error_px},
        {"position_m", camera.position_error_m},
        {"rotation_deg", RadToDeg(camera.rotation_error_rad)}}}};
}

/// Image of a view with its detected corners, at half size.
cv::Mat3b Tile(const CalibrationView& view, const Chessboard& board) {
  const models::Image& image = view.image;
  const cv::Mat1b gray(image.height, image.width, const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat3b tile;
  cv::cvtColor(gray, tile, cv::COLOR_GRAY2BGR);
  if (view.corners) {
    std::vector<cv::Point2f> corners;
    for (const Eigen::Vector2d& pixel : *view.corners) {
      corners.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
    }
    cv::drawChessboardCorners(tile, board.corner_count(), corners, true);
  }
  cv::resize(tile, tile, {std::max(1, image.width / 2), std::max(1, image.height / 2)}, 0.0, 0.0, cv::INTER_AREA);
  return tile;
}

}  // namespace

runner::Calibration CalibrationOf(const CalibrationRun& run) {
  runner::Calibration calibration;
  if (run.imu) calibration.imu = run.imu->mounting;
  if (run.camera) {
    calibration.camera_model = run.camera->fit.model;
    calibration.camera = run.camera->mounting;
  }
  return calibration;
}

std::string CalibrationJson(const CalibrationRun& run) {
  Json json{{"schema", "touchdown.calibration"}, {"version", util::Version()}};
  if (run.scenario) {
    json["scenario"] = run.scenario->name;
    json["seed"] = run.scenario->seed;
  }
  if (run.imu) json["imu"] = ImuJson(*run.imu, run.scenario);
  if (run.camera) json["camera"] = CameraJson(*run.camera, run.scenario.value());
  for (const auto& [name, value] : util::PlatformFacts()) json["platform"][name] = value;
  return json.dump(2) + "\n";
}

std::string CalibrationText(const CalibrationRun& run) {
  std::string text;
  if (run.imu) {
    const auto& [roll, pitch, yaw] = run.imu->mounting.misalignment_deg;
    text += fmt::format("IMU: roll {:.3f} deg, pitch {:.3f} deg from {} samples; yaw is not observable from gravity\n",
                        roll, pitch, run.imu->estimate.samples);
    if (run.scenario) text += fmt::format("  error: tilt {:.3f} deg\n", RadToDeg(run.imu->tilt_error_rad));
  }
  if (run.camera) {
    const CameraCalibration& camera = *run.camera;
    const models::CameraModel& c = camera.fit.model;
    const auto& [roll, pitch, yaw] = camera.mounting.misalignment_deg;
    const Eigen::Vector3d& p = camera.mounting.position_m;
    text += fmt::format(
        "camera: fx {:.2f} fy {:.2f} cx {:.2f} cy {:.2f} px, k1 {:.4f} k2 {:.4f}; {} of {} views, reprojection {:.3f} "
        "px\n"
        "  mounting: [{:.4f}, {:.4f}, {:.4f}] m, roll {:.3f} pitch {:.3f} yaw {:.3f} deg\n"
        "  error: focal {:.3f} px, principal point {:.3f} px, position {:.2f} mm, rotation {:.3f} deg\n",
        c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, camera.views_used(), camera.views.size(), camera.fit.rms_px,
        p.x(), p.y(), p.z(), roll, pitch, yaw, camera.focal_error_px, camera.principal_point_error_px,
        1e3 * camera.position_error_m, RadToDeg(camera.rotation_error_rad));
  }
  return text;
}

std::string CalibrationViewsPng(const CameraCalibration& camera, const Chessboard& board) {
  constexpr std::size_t kColumns = 6;
  std::vector<cv::Mat3b> tiles;
  for (const CalibrationView& view : camera.views) tiles.push_back(Tile(view, board));
  const cv::Size size = tiles.front().size();
  const std::size_t rows = (tiles.size() + kColumns - 1) / kColumns;
  cv::Mat3b sheet(static_cast<int>(rows) * size.height, static_cast<int>(kColumns) * size.width, cv::Vec3b(40, 40, 40));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const cv::Point corner(static_cast<int>(i % kColumns) * size.width, static_cast<int>(i / kColumns) * size.height);
    tiles[i].copyTo(sheet(cv::Rect(corner, size)));
  }
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", sheet, png)) throw std::runtime_error("OpenCV cannot encode the calibration views");
  return {png.begin(), png.end()};
}

}  // namespace touchdown::laboratory
