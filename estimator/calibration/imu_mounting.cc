#include "estimator/calibration/imu_mounting.h"

#include <cmath>
#include <string>

#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::estimator::calibration {
namespace {

using Eigen::Vector3d;

/// Statistics of the samples.
struct Means {
  Vector3d specific_force = Vector3d::Zero();
  Vector3d scatter = Vector3d::Zero();  ///< 1-sigma of the specific force, per axis.
  Vector3d rate = Vector3d::Zero();     ///< rad/s.
};

Means MeansOf(std::span<const models::ImuSample> samples) {
  const auto count = static_cast<double>(samples.size());
  Means means;
  for (const models::ImuSample& sample : samples) {
    means.specific_force += sample.specific_force_U / count;
    means.rate += sample.w_WU_U / count;
  }
  Vector3d variance = Vector3d::Zero();
  for (const models::ImuSample& sample : samples) {
    variance += (sample.specific_force_U - means.specific_force).cwiseAbs2() / (count - 1.0);
  }
  means.scatter = variance.cwiseSqrt();
  return means;
}

/// The value with two decimals, truncated, and its unit.
std::string Format(double value, const char* unit) {
  const std::string digits = std::to_string(value);
  return digits.substr(0, digits.find('.') + 3) + " " + unit;
}

void RequireRest(const Means& means, const ImuMountingConfig& config) {
  if (!means.specific_force.allFinite() || !means.rate.allFinite()) {
    throw InputError("an IMU sample has a value that is not finite");
  }
  if (const double scatter = means.scatter.maxCoeff(); !(scatter <= config.max_scatter_m_s2)) {
    throw InputError("the vehicle is not at rest: the standard deviation of its specific force is " +
                     Format(scatter, "m/s^2") + "; allowed: at most " + Format(config.max_scatter_m_s2, "m/s^2"));
  }
  if (const double rate = means.rate.norm(); !(rate <= config.max_rate_rad_s)) {
    throw InputError("the vehicle is not at rest: its mean angular rate is " + Format(rate, "rad/s") +
                     "; allowed: at most " + Format(config.max_rate_rad_s, "rad/s"));
  }
  const double force = means.specific_force.norm();
  if (!(std::abs(force - models::kGravity_m_s2) <= config.max_gravity_error_m_s2)) {
    throw InputError("the mean specific force is " + Format(force, "m/s^2") + "; allowed: within " +
                     Format(config.max_gravity_error_m_s2, "m/s^2") + " of gravity, 9.81 m/s^2");
  }
}

}  // namespace

ImuMounting FindImuMounting(std::span<const models::ImuSample> samples, const ImuMountingConfig& config) {
  if (samples.size() < 2 || samples.size() < config.min_samples) {
    throw InputError("too few samples of the IMU at rest: " + std::to_string(samples.size()) + "; at least " +
                     std::to_string(config.min_samples) + " are needed");
  }
  const Means means = MeansOf(samples);
  RequireRest(means, config);
  const Vector3d g_U = means.specific_force.normalized();
  const double mean_sigma = means.scatter.maxCoeff() / std::sqrt(static_cast<double>(samples.size()));
  return {.R_BU = models::ShortestRotation(g_U, Vector3d::UnitZ()),
          .noise_sigma_rad = mean_sigma / means.specific_force.norm(),
          .samples = samples.size()};
}

}  // namespace touchdown::estimator::calibration
