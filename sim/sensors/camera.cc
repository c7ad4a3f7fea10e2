#include "sim/sensors/camera.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::sim {
namespace {

constexpr models::Tick kMaxNodes = 64;

void RequireConsistent(const CameraConfig& c) {
  if (c.exposure_s() > 1.0 / c.rate_hz) {
    throw InputError("camera: exposure_ms must be at most the time between two frames, 1000 / rate_hz");
  }
  if (c.latency_ms < 0.5 * c.exposure_ms) {
    throw InputError("camera: latency_ms must be at least half of exposure_ms");
  }
}

}  // namespace

void Describe(models::ConfigVisitor& v, CameraConfig& c) {
  using namespace models;
  v.Keys({"model", "Image size, lens and distortion, as keys or as the name of a ROS camera_info file."}, c.model,
         kCameraModelFile);
  v.Integer({"rate_hz", "Frames per second. Must divide time.ticks_per_s."}, c.rate_hz, kRate_hz);
  v.Number({"noise_sigma", "Standard deviation of each pixel's noise, in gray levels of 0 to 255."}, c.noise_sigma,
           kNoUnit, Between(0.0, ImageNoise::kMaxSigma));
  v.Number({"exposure_ms", "Exposure time, at most the time between two frames. A larger value blurs motion more."},
           c.exposure_ms, kMillisecond, Between(0.0, 1000.0));
  v.Number({"latency_ms", "Time from mid-exposure to the delivery of a frame, at least half the exposure time."},
           c.latency_ms, kMillisecond, Between(0.0, 1000.0));
  v.Number({"vibration_rad_s2_m",
            "Compliance of the camera's mount: its tilt per acceleration of the rotors' vibration across the optical "
            "axis. 0 is rigid; a larger value blurs the frames more."},
           c.vibration_rad_s2_m, {"rad s^2/m"}, Between(0.0, 0.05));
  v.Check("", [&c] { RequireConsistent(c); });
}

void CameraConfig::Validate(const models::TimeBase& time) const {
  models::ValidateConfig(*this);
  time.PeriodOf(rate_hz);
}

Camera::Camera(const CameraConfig& config, const Eigen::Isometry3d& X_BC, World& world, const models::TimeBase& time,
               std::uint64_t seed)
    : config_((config.Validate(time), config)),
      X_BC_(X_BC),
      world_(world),
      period_(time.PeriodOf(config.rate_hz)),
      half_exposure_(0.5 * config.exposure_s() * time.ticks_per_s),
      reach_(static_cast<models::Tick>(std::ceil(half_exposure_))),
      imager_(world.model(), CameraOptics(config.model), {config.noise_sigma}, seed) {
  latency_ = std::max(time.FromSeconds(config.latency_s()), reach_);
}

Eigen::Isometry3d Camera::X_WC(const TrueState& truth) const {
  const Eigen::Vector3d& vibration = truth.vibration_m_s2_B;
  const Eigen::Vector3d tilt_B = config_.vibration_rad_s2_m * Eigen::Vector3d(-vibration.y(), vibration.x(), 0.0);
  Eigen::Isometry3d X_BC = X_BC_;
  X_BC.linear() = models::RotationExp(tilt_B) * X_BC_.linear();
  return truth.X_WB * X_BC;
}

std::optional<models::CameraFrame> Camera::Sample(const TrueState& truth) {
  StorePose(truth);
  const models::Tick mid_exposure = truth.tick - reach_;
  if (mid_exposure >= 0 && mid_exposure % period_ == 0) {
    pending_.push_back({mid_exposure + latency_, Expose(mid_exposure)});
  }
  if (pending_.empty() || pending_.front().due > truth.tick) return std::nullopt;
  models::CameraFrame frame = std::move(pending_.front().frame);
  pending_.pop_front();
  return frame;
}

void Camera::StorePose(const TrueState& truth) {
  if (newest_ && truth.tick != *newest_ + 1) throw std::logic_error("the camera was not sampled at every tick");
  newest_ = truth.tick;
  poses_.push_back(X_WC(truth));
  if (static_cast<models::Tick>(poses_.size()) > 2 * reach_ + 1) poses_.pop_front();
}

Eigen::Isometry3d Camera::PoseAt(double ticks_ago) const {
  const double index = std::max(0.0, static_cast<double>(poses_.size() - 1) - ticks_ago);
  const auto before = static_cast<std::size_t>(index);
  if (before + 1 >= poses_.size()) return poses_.back();
  const std::array<Eigen::Isometry3d, 2> neighbors{poses_[before], poses_[before + 1]};
  return PoseAlong(neighbors, index - static_cast<double>(before));
}

std::vector<Eigen::Isometry3d> Camera::ExposedPath() const {
  const models::Tick steps = std::min(4 * reach_, kMaxNodes);
  if (steps == 0) return {poses_.back()};
  std::vector<Eigen::Isometry3d> path;
  for (models::Tick i = 0; i <= steps; ++i) {
    const double since_mid = half_exposure_ * (2.0 * static_cast<double>(i) / static_cast<double>(steps) - 1.0);
    path.push_back(PoseAt(static_cast<double>(reach_) - since_mid));
  }
  return path;
}

models::CameraFrame Camera::Expose(models::Tick mid_exposure) {
  const auto begin = std::chrono::steady_clock::now();
  models::CameraFrame frame{.mid_exposure = mid_exposure, .image = imager_.Capture(world_.data(), ExposedPath())};
  render_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return frame;
}

}  // namespace touchdown::sim
