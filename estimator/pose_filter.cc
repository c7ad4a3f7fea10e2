#include "estimator/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace touchdown::estimator {

namespace {

constexpr std::array<std::string_view, 2> kVisionNoiseNames = {"height", "covariance"};

}  // namespace

void Describe(models::ConfigVisitor& v, PoseFilterConfig& c) {
  using namespace models;
  v.Number({"xy_acceleration_noise_m_s2_sqrt_hz",
            "Density of the horizontal acceleration noise in the motion model. Larger follows vision sooner, with more "
            "noise."},
           c.xy_acceleration_noise_m_s2_sqrt_hz, kMeterPerSecond2RootHertz, kPositive);
  v.Number({"z_acceleration_noise_m_s2_sqrt_hz",
            "Density of the vertical acceleration noise in the motion model. Larger follows vision sooner, with more "
            "noise."},
           c.z_acceleration_noise_m_s2_sqrt_hz, kMeterPerSecond2RootHertz, kPositive);
  v.Choice(
      {"vision_noise",
       "Source of the standard deviation of vision's position: proportional to the height, or the covariance of the "
       "pose. It is at least min_xy_noise_m and min_z_noise_m."},
      c.vision_noise, kVisionNoiseNames);
  v.Number({"xy_noise_per_height",
            "Standard deviation of vision's horizontal position per meter of height, from tilt errors. Larger follows "
            "vision later."},
           c.xy_noise_per_height, kNoUnit, kPositive);
  v.Number({"min_xy_noise_m",
            "Smallest standard deviation of vision's horizontal position. Larger follows vision later near the pad."},
           c.min_xy_noise_m, kMeter, kPositive);
  v.Number(
      {"z_noise_per_height", "Standard deviation of vision's height per meter of height. Larger follows vision later."},
      c.z_noise_per_height, kNoUnit, kPositive);
  v.Number(
      {"min_z_noise_m", "Smallest standard deviation of vision's height. Larger follows vision later near the pad."},
      c.min_z_noise_m, kMeter, kPositive);
  v.Number({"initial_speed_m_s",
            "Standard deviation of each velocity component at the first position. Larger lets the first frames change "
            "the velocity faster."},
           c.initial_speed_m_s, kMeterPerSecond, kPositive);
}

void PoseFilterConfig::Validate() const { models::ValidateConfig(*this); }

PoseFilter::PoseFilter(const PoseFilterConfig& config, const models::TimeBase& time) : config_(config), time_(time) {
  config.Validate();
}

void PoseFilter::Update(models::Tick mid_exposure, const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& covariance) {
  if (newest_.has_value() && mid_exposure <= *newest_) return;
  const Eigen::Vector3d noise = Noise(p_WB.z(), covariance);
  const Eigen::Vector3d density = AccelerationDensity();
  for (int i = 0; i < 3; ++i) {
    Axis& axis = axes_[static_cast<std::size_t>(i)];
    if (newest_.has_value()) {
      axis.Predict(time_.ToSeconds(mid_exposure - *newest_), density[i]);
      axis.Correct(p_WB[i], noise[i]);
    } else {
      axis.Start(p_WB[i], noise[i], config_.initial_speed_m_s);
    }
  }
  newest_ = mid_exposure;
}

std::optional<models::VehicleEstimate::Motion> PoseFilter::At(models::Tick tick) const {
  if (!newest_.has_value()) return std::nullopt;
  const double dt_s = time_.ToSeconds(tick - *newest_);
  models::VehicleEstimate::Motion motion;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& state = axes_[static_cast<std::size_t>(i)].state;
    motion.p_WB[i] = state[0] + dt_s * state[1];
    motion.v_WB[i] = state[1];
  }
  return motion;
}

std::optional<Eigen::Matrix<double, 6, 6>> PoseFilter::CovarianceAt(models::Tick tick) const {
  if (!newest_.has_value()) return std::nullopt;
  const Eigen::Vector3d density = AccelerationDensity();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    Axis axis = axes_[static_cast<std::size_t>(i)];
    axis.Predict(time_.ToSeconds(tick - *newest_), density[i]);
    covariance(i, i) = axis.covariance(0, 0);
    covariance(i, i + 3) = covariance(i + 3, i) = axis.covariance(0, 1);
    covariance(i + 3, i + 3) = axis.covariance(1, 1);
  }
  return covariance;
}

Eigen::Vector3d PoseFilter::AccelerationDensity() const {
  const double xy = config_.xy_acceleration_noise_m_s2_sqrt_hz;
  return {xy, xy, config_.z_acceleration_noise_m_s2_sqrt_hz};
}

Eigen::Vector3d PoseFilter::Noise(double height_m, const Eigen::Matrix3d& covariance) const {
  const double xy = config_.xy_noise_per_height * height_m, z = config_.z_noise_per_height * height_m;
  const Eigen::Vector3d least(config_.min_xy_noise_m, config_.min_xy_noise_m, config_.min_z_noise_m);
  const Eigen::Vector3d noise = config_.vision_noise == VisionNoise::kHeight
                                    ? Eigen::Vector3d(xy, xy, z)
                                    : Eigen::Vector3d(covariance.diagonal().cwiseMax(0.0).cwiseSqrt());
  return noise.cwiseMax(least);
}

void PoseFilter::Axis::Start(double position, double position_sigma, double speed_sigma) {
  state = {position, 0.0};
  covariance = Eigen::Vector2d(position_sigma * position_sigma, speed_sigma * speed_sigma).asDiagonal();
}

void PoseFilter::Axis::Predict(double dt_s, double acceleration_density) {
  Eigen::Matrix2d F;
  F << 1.0, dt_s, 0.0, 1.0;
  Eigen::Matrix2d Q;
  Q << dt_s * dt_s * dt_s / 3.0, dt_s * dt_s / 2.0, dt_s * dt_s / 2.0, dt_s;
  state = F * state;
  covariance = F * covariance * F.transpose() + acceleration_density * acceleration_density * Q;
}

void PoseFilter::Axis::Correct(double position, double position_sigma) {
  const double innovation_variance = covariance(0, 0) + position_sigma * position_sigma;
  const Eigen::Vector2d gain = covariance.col(0) / innovation_variance;
  state += gain * (position - state[0]);
  covariance -= gain * covariance.row(0).eval();
}

}  // namespace touchdown::estimator
