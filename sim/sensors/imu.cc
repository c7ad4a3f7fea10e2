#include "sim/sensors/imu.h"

#include <cmath>

#include "models/angles.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

Vector3d Saturated(const Vector3d& value, double range) { return value.cwiseMax(-range).cwiseMin(range); }

Vector3d DrawnBias(models::RandomStream& random, double sigma) { return sigma * random.NormalVector3(); }

}  // namespace

void Describe(models::ConfigVisitor& v, ImuConfig& c) {
  using namespace models;
  v.Integer({"rate_hz", "Samples per second, and the rate of the attitude loop. Must divide time.ticks_per_s."},
            c.rate_hz, kRate_hz);
  v.Number({"gyro_noise_rad_s_sqrt_hz", "Density of the gyro's white noise. A larger value makes the samples noisier."},
           c.gyro_noise_rad_s_sqrt_hz, kRadianPerSecondRootHertz, kNotNegative);
  v.Number({"accelerometer_noise_m_s2_sqrt_hz",
            "Density of the accelerometer's white noise. A larger value makes the samples noisier."},
           c.accelerometer_noise_m_s2_sqrt_hz, kMeterPerSecond2RootHertz, kNotNegative);
  v.Number({"gyro_bias_sigma_deg_s", "Standard deviation of the gyro's turn-on bias, per axis."},
           c.gyro_bias_sigma_deg_s, kDegreePerSecond, kNotNegative);
  v.Number({"accelerometer_bias_sigma_m_s2", "Standard deviation of the accelerometer's turn-on bias, per axis."},
           c.accelerometer_bias_sigma_m_s2, kMeterPerSecond2, kNotNegative);
  v.Number({"gyro_range_deg_s", "Largest rate that the gyro measures. It saturates beyond."}, c.gyro_range_deg_s,
           kDegreePerSecond, kPositive);
  v.Number({"accelerometer_range_m_s2", "Largest specific force that the accelerometer measures. It saturates beyond."},
           c.accelerometer_range_m_s2, kMeterPerSecond2, kPositive);
}

void ImuConfig::Validate(const models::TimeBase& time) const {
  models::ValidateConfig(*this);
  time.PeriodOf(rate_hz);
}

Imu::Imu(const ImuConfig& config, const Eigen::Isometry3d& X_BU, const models::TimeBase& time, std::uint64_t seed,
         const GroundTilt& ground)
    : config_(config),
      X_BU_(X_BU),
      gravity_W_(ground.Gravity()),
      tick_s_(time.period_s()),
      period_(time.PeriodOf(config.rate_hz)),
      noise_(seed, "imu.noise") {
  config.Validate(time);
  models::RandomStream random(seed, "imu.bias");
  gyro_bias_ = DrawnBias(random, models::DegToRad(config.gyro_bias_sigma_deg_s));
  accelerometer_bias_ = DrawnBias(random, config.accelerometer_bias_sigma_m_s2);
}

std::optional<models::ImuSample> Imu::Sample(const TrueState& truth) {
  Accumulate(truth);
  if (truth.tick % period_ != 0) return std::nullopt;

  const double sqrt_rate = std::sqrt(static_cast<double>(config_.rate_hz));
  const Vector3d specific_force = specific_force_sum_ / count_ + accelerometer_bias_ +
                                  config_.accelerometer_noise_m_s2_sqrt_hz * sqrt_rate * noise_.NormalVector3();
  const Vector3d rate =
      rate_sum_ / count_ + gyro_bias_ + config_.gyro_noise_rad_s_sqrt_hz * sqrt_rate * noise_.NormalVector3();
  specific_force_sum_.setZero();
  rate_sum_.setZero();
  count_ = 0;
  return models::ImuSample{.tick = truth.tick,
                           .specific_force_U = Saturated(specific_force, config_.accelerometer_range_m_s2),
                           .w_WU_U = Saturated(rate, models::DegToRad(config_.gyro_range_deg_s))};
}

/// Adds the means over the last tick, using the attitude and rate at its middle.
void Imu::Accumulate(const TrueState& truth) {
  const Vector3d& alpha = truth.alpha_WB_B;
  const Vector3d w = truth.w_WB_B - 0.5 * tick_s_ * alpha;
  const Vector3d p_BU = X_BU_.translation();
  const Eigen::Matrix3d R_WB = truth.X_WB.linear() * models::RotationExp(-0.5 * tick_s_ * w);
  const Vector3d specific_force_B =
      R_WB.transpose() * (truth.a_WB - gravity_W_) + alpha.cross(p_BU) + w.cross(w.cross(p_BU));
  specific_force_sum_ += X_BU_.linear().transpose() * specific_force_B;
  rate_sum_ += X_BU_.linear().transpose() * w;
  ++count_;
}

}  // namespace touchdown::sim
