#include "sim/dynamics/hand.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

constexpr double kLowest_m = 0.35;
constexpr double kLift_s = 2.5;     // Time from the lift to the first of the random heights.
constexpr double kMaxSlope = 0.25;  // Largest horizontal distance from the pad along each axis, divided by the height.

/// Minimum-jerk profile: increases from 0 to 1 over [0, 1], at rest at both ends.
double MinimumJerk(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

}  // namespace

void Describe(models::ConfigVisitor& v, HandConfig& c) {
  using namespace models;
  v.Boolean(
      {"carries", "Whether the vehicle is hand-held. It then starts on the ground and the scenario has no script."},
      c.carries);
  v.Number({"duration_s", "Time from lifting the vehicle to the end."}, c.duration_s, kSecond, Between(10.0, 600.0));
  v.Number({"max_height_m", "Largest height of the body's origin, reached at least once."}, c.max_height_m, kMeter,
           Between(0.5, 3.0));
  v.Number({"max_tilt_deg", "Largest roll and largest pitch, each reached at least once."}, c.max_tilt_deg, kDegree,
           Between(0.0, 40.0));
  v.Number({"max_yaw_deg", "Largest yaw to either side, reached at least once."}, c.max_yaw_deg, kDegree,
           Between(0.0, 80.0));
  v.Number({"tremor_m", "Amplitude of the hand's tremor along each axis. A larger value shakes the camera more."},
           c.tremor_m, kMeter, Between(0.0, 0.01));
  v.Number({"tremor_deg", "Amplitude of the hand's tremor about each axis. A larger value shakes the camera more."},
           c.tremor_deg, kDegree, Between(0.0, 0.5));
  v.Number({"tremor_hz", "Frequency of the hand's tremor."}, c.tremor_hz, kHertz, Between(0.1, 30.0));
}

void HandConfig::Validate() const { models::ValidateConfig(*this); }

Hand::MinimumJerkPath::MinimumJerkPath(double start, double middle, double reach, double duration_s,
                                       models::RandomStream& random)
    : times_s_{0.0}, values_{start} {
  constexpr double kShortest_s = 2.0, kLongest_s = 4.0;
  for (double t_s = kLift_s; t_s < duration_s; t_s += random.Uniform(kShortest_s, kLongest_s)) {
    times_s_.push_back(t_s);
    values_.push_back(middle + random.Uniform(-reach, reach));
  }
  const int last = static_cast<int>(values_.size()) - 1;
  const int high = random.UniformInt(1, last - 1);
  values_[static_cast<std::size_t>(high)] = middle + reach;
  values_[static_cast<std::size_t>(random.UniformInt(high + 1, last))] = middle - reach;
}

double Hand::MinimumJerkPath::At(double t_s) const {
  const auto next = std::upper_bound(times_s_.begin(), times_s_.end(), t_s);
  if (next == times_s_.begin()) return values_.front();
  if (next == times_s_.end()) return values_.back();
  const auto i = static_cast<std::size_t>(next - times_s_.begin());
  const double fraction = (t_s - times_s_[i - 1]) / (times_s_[i] - times_s_[i - 1]);
  return values_[i - 1] + (values_[i] - values_[i - 1]) * MinimumJerk(fraction);
}

Hand::Hand(const HandConfig& config, const Eigen::Isometry3d& X_WB, const models::TimeBase& time, std::uint64_t seed)
    : config_(config), time_(time), X_WB_at_rest_(X_WB) {
  config.Validate();
  models::RandomStream random(seed, "hand");
  const auto add_path = [&](double start, double middle, double reach) {
    paths_.emplace_back(start, middle, reach, config.duration_s, random);
  };
  const double half_range_m = 0.5 * (config.max_height_m - kLowest_m);
  add_path(X_WB.translation().z(), kLowest_m + half_range_m, half_range_m);
  for (int i = 0; i < 2; ++i) add_path(0.0, 0.0, models::DegToRad(config.max_tilt_deg));
  add_path(models::TaitBryanFromRotation(X_WB.linear()).yaw, 0.0, models::DegToRad(config.max_yaw_deg));
  for (int i = 0; i < 2; ++i) add_path(0.0, 0.0, kMaxSlope);
  for (int i = 0; i < 6; ++i) tremor_phases_.push_back(random.Uniform(-models::kPi, models::kPi));
}

Eigen::Isometry3d Hand::PoseAt(double t_s) const {
  if (t_s <= 0.0) return X_WB_at_rest_;
  const double grip = MinimumJerk(t_s / kLift_s);
  const auto tremor = [&](std::size_t first, double amplitude) {
    Vector3d sway;
    for (std::size_t i = 0; i < 3; ++i) {
      sway[static_cast<Eigen::Index>(i)] =
          grip * amplitude * std::sin(2.0 * models::kPi * config_.tremor_hz * t_s + tremor_phases_[first + i]);
    }
    return sway;
  };
  const auto value = [&](std::size_t i) { return paths_[i].At(t_s); };
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan({value(1), value(2), value(3)});
  X_WB.translation() = value(0) * Vector3d(value(4), value(5), 1.0);
  X_WB.translation().head<2>() += (1.0 - grip) * X_WB_at_rest_.translation().head<2>();
  X_WB.translation() += tremor(0, config_.tremor_m);
  X_WB.linear() *= models::RotationExp(tremor(3, models::DegToRad(config_.tremor_deg)));
  return X_WB;
}

BodyMotion Hand::At(models::Tick tick) const {
  constexpr double kHalfStep_s = 1e-4;
  const double t_s = time_.ToSeconds(tick) - kTimeAtRest_s;
  const Eigen::Isometry3d before = PoseAt(t_s - kHalfStep_s), after = PoseAt(t_s + kHalfStep_s);
  return {.X_WB = PoseAt(t_s),
          .v_WB = (after.translation() - before.translation()) / (2.0 * kHalfStep_s),
          .w_WB_B = models::RotationLog(before.linear().transpose() * after.linear()) / (2.0 * kHalfStep_s)};
}

}  // namespace touchdown::sim
