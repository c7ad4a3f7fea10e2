#include "scenarios/laboratory/calibration_bench.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "estimator/calibration/camera_mounting.h"
#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/laboratory/calibration_camera.h"
#include "scenarios/laboratory/calibration_views.h"
#include "sim/sensors/imu.h"
#include "sim/sensors/tracking_system.h"

namespace touchdown::laboratory {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Seed of a random source, different from the seed of the same source in a flight.
std::uint64_t CalibrationSeed(const runner::Scenario& scenario, const std::string& source) {
  return models::RandomStream(scenario.seed, "calibration." + source).Bits();
}

/// Draws the pose of the board on the floor, inside the volume of the tracking system.
Isometry3d DrawBoardPose(models::RandomStream& random) {
  Isometry3d X_WE(Eigen::Translation3d(random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 0.0));
  X_WE.linear() = models::RotationExp(random.Uniform(-models::kPi, models::kPi) * Vector3d::UnitZ());
  return X_WE;
}

/// Measurements of the tracking system for an object placed at a sequence of poses.
class TrackedObject {
 public:
  TrackedObject(const runner::Scenario& scenario, const std::string& name)
      : time_(scenario.time),
        tracking_(std::get<sim::TrackingSystemConfig>(scenario.sensors), scenario.time,
                  CalibrationSeed(scenario, "tracking." + name)) {}

  /// Mean measured pose over `rest_s` seconds at rest; nullopt when the object is occluded all the time.
  std::optional<Isometry3d> Measure(const Isometry3d& X_WB, double rest_s) {
    sim::TrueState at_rest;
    at_rest.X_WB = X_WB;
    std::vector<Isometry3d> poses;
    for (const models::Tick end = tick_ + time_.FromSeconds(rest_s); tick_ < end; ++tick_) {
      at_rest.tick = tick_;
      if (const auto tracked = tracking_.Sample(at_rest)) poses.push_back(tracked->X_WB);
    }
    if (poses.empty()) return std::nullopt;
    return estimator::calibration::MeanPose(poses).X_AB;
  }

 private:
  models::TimeBase time_;
  sim::TrackingSystem tracking_;
  models::Tick tick_ = 0;
};

/// Poses of vehicle and board measured by the tracking system for one view.
struct TrackedView {
  std::optional<Isometry3d> X_WB, X_WE;
};

estimator::calibration::PoseMean MeanMounting(const std::vector<TrackedView>& tracked,
                                              const std::vector<std::optional<Isometry3d>>& X_EC) {
  std::vector<estimator::calibration::PatternView> views;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    if (!tracked[i].X_WB || !tracked[i].X_WE || !X_EC[i]) continue;
    views.push_back({*tracked[i].X_WB, *tracked[i].X_WE, *X_EC[i]});
  }
  return estimator::calibration::FindCameraMounting(views);
}

void CompareWithTruth(const runner::Scenario& scenario, CameraCalibration& result) {
  const models::CameraModel &estimated = result.fit.model, &truth = scenario.camera.model;
  const Isometry3d X_BC = scenario.vehicle.X_BC();
  result.focal_error_px = std::max(std::abs(estimated.fx_px - truth.fx_px), std::abs(estimated.fy_px - truth.fy_px));
  result.principal_point_error_px = std::hypot(estimated.cx_px - truth.cx_px, estimated.cy_px - truth.cy_px);
  result.position_error_m = (result.X_BC.X_AB.translation() - X_BC.translation()).norm();
  result.rotation_error_rad = models::RotationLog(result.X_BC.X_AB.linear() * X_BC.linear().transpose()).norm();
}

}  // namespace

int CameraCalibration::views_used() const {
  return static_cast<int>(
      std::count_if(fit.X_EC.begin(), fit.X_EC.end(), [](const auto& X_EC) { return X_EC.has_value(); }));
}

ImuCalibration ImuCalibrationFrom(std::span<const models::ImuSample> samples) {
  const estimator::calibration::ImuMounting estimate = estimator::calibration::FindImuMounting(samples);
  Isometry3d X_BU = Isometry3d::Identity();
  X_BU.linear() = estimate.R_BU;
  return {.estimate = estimate, .mounting = models::ImuMountingOf(X_BU)};
}

ImuCalibration CalibrateImu(const runner::Scenario& scenario, double rest_s) {
  const Isometry3d X_BU = scenario.vehicle.X_BU();
  sim::Imu imu(scenario.imu, X_BU, scenario.time, CalibrationSeed(scenario, "imu"));
  std::vector<models::ImuSample> samples;
  sim::TrueState at_rest;
  for (const models::Tick end = scenario.time.FromSeconds(rest_s); at_rest.tick < end; ++at_rest.tick) {
    if (const auto sample = imu.Sample(at_rest)) samples.push_back(*sample);
  }
  ImuCalibration result = ImuCalibrationFrom(samples);
  result.tilt_error_rad =
      models::AngleBetween(result.estimate.R_BU * X_BU.linear().transpose() * Vector3d::UnitZ(), Vector3d::UnitZ());
  return result;
}

CameraCalibration CalibrateCamera(const runner::Scenario& scenario, const CameraCalibrationConfig& config,
                                  const CalibrationProgress& progress) {
  const models::CameraModel& camera = scenario.camera.model;
  models::RandomStream random(scenario.seed, "calibration.views");
  const Isometry3d X_WE = DrawBoardPose(random), X_CB = scenario.vehicle.X_BC().inverse();
  const std::vector<Isometry3d> poses = DrawCalibrationViews(config.board, camera, config.views, random);
  ChessboardCamera board_camera(config.board, X_WE, scenario.camera, CalibrationSeed(scenario, "camera"));
  TrackedObject vehicle(scenario, "vehicle"), board(scenario, "board");

  CameraCalibration result;
  std::vector<TrackedView> tracked;
  std::vector<ImageCorners> corners;
  for (const Isometry3d& X_EC : poses) {
    if (progress) progress(static_cast<double>(result.views.size()) / static_cast<double>(poses.size()));
    const Isometry3d X_WC = X_WE * X_EC;
    CalibrationView view{.image = board_camera.Capture(X_WC), .corners = {}};
    view.corners = FindCorners(view.image.View(), config.board);
    const TrackedView tracked_view{.X_WB = vehicle.Measure(X_WC * X_CB, config.rest_s),
                                   .X_WE = board.Measure(X_WE, config.rest_s)};
    if (view.corners) {
      corners.push_back(*view.corners);
      tracked.push_back(tracked_view);
    }
    result.views.push_back(std::move(view));
  }
  result.fit = FitCamera(corners, config.board, camera.width_px, camera.height_px, config.terms);
  result.X_BC = MeanMounting(tracked, result.fit.X_EC);
  result.mounting = models::CameraMountingOf(result.X_BC.X_AB);
  CompareWithTruth(scenario, result);
  return result;
}

}  // namespace touchdown::laboratory
