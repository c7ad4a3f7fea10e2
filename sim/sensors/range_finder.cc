#include "sim/sensors/range_finder.h"

#include "models/error.h"
#include "sim/dynamics/world.h"

namespace touchdown::sim {

void Describe(models::ConfigVisitor& v, RangeFinderConfig& c) {
  using namespace models;
  v.Integer({"rate_hz", "Readings per second. Must divide time.ticks_per_s."}, c.rate_hz, kRate_hz);
  v.Vector3({"position_m", "Position of the sensor in B. It measures along -Z of B."}, c.position_m, kMeter,
            Between(-10.0, 10.0));
  v.Number({"min_range_m", "Smallest range. There is no reading below it."}, c.min_range_m, kMeter, kNotNegative);
  v.Number({"max_range_m", "Largest range. There is no reading above it."}, c.max_range_m, kMeter, kPositive);
  v.Number({"noise_m", "Standard deviation of the noise. Larger scatters the readings more."}, c.noise_m, kMeter,
           kNotNegative);
  v.Check("", [&c] {
    if (c.min_range_m >= c.max_range_m) throw InputError("min_range_m must be below max_range_m");
  });
}

void RangeFinderConfig::Validate(const models::TimeBase& time) const {
  models::ValidateConfig(*this);
  time.PeriodOf(rate_hz);
}

RangeFinder::RangeFinder(const RangeFinderConfig& config, const World& world, const models::TimeBase& time,
                         std::uint64_t seed)
    : config_(config), world_(&world), period_(time.PeriodOf(config.rate_hz)), noise_(seed, "range_finder.noise") {
  config.Validate(time);
}

std::optional<models::RangeReading> RangeFinder::Sample(const TrueState& truth) {
  if (truth.tick % period_ != 0) return std::nullopt;
  const double error_m = config_.noise_m * noise_.Normal();
  const Eigen::Vector3d down_W = -truth.X_WB.linear().col(2);
  const std::optional<double> distance_m = world_->DistanceAlong(truth.X_WB * config_.position_m, down_W);
  if (!distance_m) return std::nullopt;
  const double range_m = *distance_m + error_m;
  if (range_m < config_.min_range_m || range_m > config_.max_range_m) return std::nullopt;
  return models::RangeReading{.tick = truth.tick, .range_m = range_m};
}

}  // namespace touchdown::sim
