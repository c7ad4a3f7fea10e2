#include "sim/sensors/tracking_system.h"

#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

double Exponential(models::RandomStream& random, double mean) { return -mean * std::log1p(-random.Uniform()); }

}  // namespace

void Describe(models::ConfigVisitor& v, TrackingSystemConfig& c) {
  using namespace models;
  v.Integer({"rate_hz", "Poses per second. Must divide time.ticks_per_s."}, c.rate_hz, kRate_hz);
  v.Number({"position_noise_m", "Standard deviation of the position noise, per axis."}, c.position_noise_m, kMeter,
           kNotNegative);
  v.Number({"rotation_noise_deg", "Standard deviation of the rotation noise, per axis."}, c.rotation_noise_deg, kDegree,
           kNotNegative);
  v.Number({"occlusions_per_s", "Mean rate at which occlusions of the markers begin; at most rate_hz."},
           c.occlusions_per_s, kPerSecond, kNotNegative);
  v.Number({"occlusion_duration_s", "Mean duration of an occlusion."}, c.occlusion_duration_s, kSecond, kTime);
  v.Number({"outlier_probability", "Probability that an occlusion causes outliers. Otherwise it causes a gap."},
           c.outlier_probability, kNoUnit, kFraction);
  v.Number({"outlier_position_m",
            "Standard deviation of an outlier's position offset, per axis. The offset is constant over the occlusion."},
           c.outlier_position_m, kMeter, kNotNegative);
  v.Number({"outlier_rotation_deg",
            "Standard deviation of an outlier's rotation offset, per axis. The offset is constant over the occlusion."},
           c.outlier_rotation_deg, kDegree, kNotNegative);
  v.Check("", [&c] {
    if (c.occlusions_per_s > c.rate_hz) {
      throw InputError("the tracking system's occlusions_per_s must be at most its rate_hz");
    }
  });
}

void TrackingSystemConfig::Validate(const models::TimeBase& time) const {
  models::ValidateConfig(*this);
  time.PeriodOf(rate_hz);
}

std::array<double, 6> TrackingSystem::Columns(const Reading& reading) {
  const Vector3d& p_WB = reading.X_WB.translation();
  const models::TaitBryan angles = models::TaitBryanFromRotation(reading.X_WB.linear());
  return {p_WB.x(),
          p_WB.y(),
          p_WB.z(),
          models::RadToDeg(angles.roll),
          models::RadToDeg(angles.pitch),
          models::RadToDeg(angles.yaw)};
}

TrackingSystem::TrackingSystem(const TrackingSystemConfig& config, const models::TimeBase& time, std::uint64_t seed)
    : config_(config),
      time_(time),
      period_(time.PeriodOf(config.rate_hz)),
      noise_(seed, "tracking.noise"),
      occlusion_random_(seed, "tracking.occlusion") {
  config.Validate(time);
  next_ = OcclusionAfter(0.0);
}

std::optional<models::TrackedPose> TrackingSystem::Sample(const TrueState& truth) {
  if (truth.tick % period_ != 0) return std::nullopt;
  const double now_s = time_.ToSeconds(truth.tick);
  while (next_ && next_->end_s <= now_s) next_ = OcclusionAfter(next_->end_s);

  Vector3d position_error = config_.position_noise_m * noise_.NormalVector3();
  Vector3d rotation_error = models::DegToRad(config_.rotation_noise_deg) * noise_.NormalVector3();
  if (next_ && next_->begin_s <= now_s) {
    if (next_->gap) return std::nullopt;
    position_error += next_->position_offset;
    rotation_error += next_->rotation_offset;
  }
  models::TrackedPose tracked{.tick = truth.tick, .X_WB = truth.X_WB};
  tracked.X_WB.translation() += position_error;
  tracked.X_WB.linear() = truth.X_WB.linear() * models::RotationExp(rotation_error);
  return tracked;
}

std::optional<TrackingSystem::Occlusion> TrackingSystem::OcclusionAfter(double time_s) {
  if (config_.occlusions_per_s == 0.0 || config_.occlusion_duration_s == 0.0) return std::nullopt;
  Occlusion occlusion;
  occlusion.begin_s = time_s + Exponential(occlusion_random_, 1.0 / config_.occlusions_per_s);
  occlusion.end_s = occlusion.begin_s + Exponential(occlusion_random_, config_.occlusion_duration_s);
  occlusion.gap = !occlusion_random_.Bernoulli(config_.outlier_probability);
  occlusion.position_offset = config_.outlier_position_m * occlusion_random_.NormalVector3();
  occlusion.rotation_offset = models::DegToRad(config_.outlier_rotation_deg) * occlusion_random_.NormalVector3();
  return occlusion;
}

}  // namespace touchdown::sim
