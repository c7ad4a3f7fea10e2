#include "tests/support/flight_rig.h"

#include <cmath>
#include <deque>
#include <ostream>

#include "models/angles.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/random_stream.h"

namespace touchdown::tests {
namespace {

using controller::Phase;
using Eigen::Vector3d;
using models::Tick;

/// Model of vision: position and yaw with slow and white noise, if the whole ring is in view.
class VisionModel {
 public:
  struct Measurement {
    Tick mid_exposure = 0, delivered = 0;
    Vector3d p = Vector3d::Zero();
    double yaw = 0.0;
  };

  VisionModel(const RigConfig& config, const models::Vehicle& vehicle)
      : config_(config), X_BC_(vehicle.X_BC()), random_(config.seed, "rig.vision") {
    slow_error_ = random_.NormalVector3();
    slow_yaw_ = random_.Normal();
  }

  std::optional<Measurement> Observe(Tick tick, Tick latency, double dt, const QuadrotorOde::State& truth) {
    const double decay = std::exp(-dt / 0.5), drive = std::sqrt(1.0 - decay * decay);
    slow_error_ = decay * slow_error_ + drive * random_.NormalVector3();
    slow_yaw_ = decay * slow_yaw_ + drive * random_.Normal();
    const Vector3d white = random_.NormalVector3();
    const double white_yaw = random_.Normal();
    if (!random_.Bernoulli(config_.detection) || !IsRingInView(truth)) return std::nullopt;

    const double xy = config_.xy_noise_per_height * truth.p.z() / std::sqrt(2.0);
    const double z = std::max(0.001, config_.z_noise_per_height * truth.p.z()) / std::sqrt(2.0);
    Measurement measurement{.mid_exposure = tick, .delivered = tick + latency, .p = truth.p};
    measurement.p += Vector3d(xy, xy, z).cwiseProduct(slow_error_ + white);
    const double yaw_error = config_.yaw_noise_rad / std::sqrt(2.0) * (slow_yaw_ + white_yaw);
    measurement.yaw = models::WrapToHalfPi(models::TaitBryanFromRotation(truth.R).yaw + yaw_error);
    return measurement;
  }

 private:
  bool IsRingInView(const QuadrotorOde::State& truth) const {
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    X_WB.linear() = truth.R;
    X_WB.translation() = truth.p;
    const Eigen::Isometry3d X_CW = (X_WB * X_BC_).inverse();
    constexpr int kPoints = 24;
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * models::kPi * i / kPoints;
      const Vector3d point = pad_.outer_radius_m * Vector3d(std::cos(angle), std::sin(angle), 0.0);
      const std::optional<Eigen::Vector2d> pixel = camera_.Project(X_CW * point);
      if (!pixel.has_value() || !camera_.Contains(*pixel)) return false;
    }
    return true;
  }

  const RigConfig& config_;
  Eigen::Isometry3d X_BC_;
  models::CameraModel camera_;
  models::LandingPad pad_;
  models::RandomStream random_;
  Vector3d slow_error_;
  double slow_yaw_ = 0.0;
};

/// Model of the IMU: averages between samples, plus bias, noise and rotor vibration.
class ImuModel {
 public:
  explicit ImuModel(const RigConfig& config) : random_(config.seed, "rig.imu") {
    gyro_bias_ = config.gyro_bias_rad_s * random_.NormalVector3();
    level_bias_ = config.level_bias_m_s2 * random_.NormalVector3();
  }

  void Accumulate(const QuadrotorOde& truth) {
    force_ += truth.specific_force();
    rate_ += truth.state.w;
    ++count_;
  }

  models::ImuSample Sample(Tick tick, bool rotors_spin) {
    const double vibration = rotors_spin ? 0.3 : 0.0;
    models::ImuSample sample{.tick = tick};
    sample.specific_force_U = force_ / count_ + level_bias_ + (0.09 + vibration) * random_.NormalVector3();
    sample.w_WU_U = rate_ / count_ + gyro_bias_ + (0.012 + 0.05 * vibration) * random_.NormalVector3();
    force_.setZero();
    rate_.setZero();
    count_ = 0;
    return sample;
  }

 private:
  models::RandomStream random_;
  Vector3d gyro_bias_, level_bias_;
  Vector3d force_ = Vector3d::Zero(), rate_ = Vector3d::Zero();
  int count_ = 0;
};

class Rig {
 public:
  explicit Rig(const RigConfig& config)
      : config_(config),
        truth_(TrueVehicle(config)),
        vision_(config, models::Vehicle()),
        imu_(config),
        attitude_(config.attitude, time_, Eigen::Matrix3d::Identity()),
        filter_(config.filter, time_),
        controller_(config.controller, models::Vehicle(), time_, kRate_hz, config.script, config.starts_airborne) {
    truth_.state.p = config.start_m;
    truth_.state.R = models::RotationFromTaitBryan({.roll = 0.0, .pitch = 0.0, .yaw = config.start_yaw});
    truth_.wind = config.wind_m_s;
    if (config.starts_airborne) truth_.StartRotorsAtHover();
  }

  RigResult Fly() {
    const Tick end = time_.FromSeconds(config_.time_limit_s);
    for (tick_ = 0; tick_ < end && !IsOver(); ++tick_) StepTick();
    result_.last_phase = output_.phase;
    result_.script_done = output_.script_done;
    if (hover_samples_ > 0) result_.hover_rmse_m = std::sqrt(hover_sum_ / hover_samples_);
    if (attitude_samples_ > 0) result_.attitude_rmse_rad = std::sqrt(attitude_sum_ / attitude_samples_);
    return result_;
  }

 private:
  static constexpr int kRate_hz = 200;

  static models::Vehicle TrueVehicle(const RigConfig& config) {
    models::Vehicle vehicle;
    vehicle.mass_kg *= config.mass_ratio;
    return vehicle;
  }

  void StepTick() {
    const double time_s = time_.ToSeconds(tick_);
    const bool pad_visible = !config_.events || config_.events(time_s, truth_);
    imu_.Accumulate(truth_);
    if (tick_ % time_.PeriodOf(60) == 0) {
      const auto measurement = vision_.Observe(tick_, time_.FromSeconds(config_.latency_s),
                                               time_.ToSeconds(time_.PeriodOf(60)), truth_.state);
      if (measurement.has_value() && pad_visible) pending_.push_back(*measurement);
    }
    if (tick_ % time_.PeriodOf(kRate_hz) == 0) Control();
    const double sink_rate = -truth_.state.v.z();
    truth_.Step(output_.rotors, time_.period_s());
    RecordTouchdown(sink_rate);
  }

  void Control() {
    attitude_.Update(imu_.Sample(tick_, truth_.state.rotor_speed[0] > 50.0), controller_.phase() == Phase::kStandby);
    while (!pending_.empty() && pending_.front().delivered <= tick_) {
      filter_.Update(pending_.front().mid_exposure, pending_.front().p, Eigen::Matrix3d::Zero());
      attitude_.CorrectYaw(pending_.front().mid_exposure, pending_.front().yaw);
      pending_.pop_front();
    }
    output_ = controller_.Update({.tick = tick_,
                                  .attitude = attitude_.attitude(),
                                  .w_WB_B = attitude_.w_WB_B(),
                                  .motion = filter_.At(tick_),
                                  .pad_seen = filter_.newest()});
    if (result_.phases.empty() || result_.phases.back() != output_.phase) {
      result_.phases.push_back(output_.phase);
      if (output_.phase == Phase::kLanding) landing_start_ = tick_;
      if (output_.phase == Phase::kTouchdown) {
        motors_off_ = tick_;
        result_.landing_s = time_.ToSeconds(tick_ - landing_start_);
      }
    }
    Observe();
  }

  void Observe() {
    const models::TaitBryan angles = models::TaitBryanFromRotation(truth_.state.R);
    const double tilt = std::acos(std::min(1.0, truth_.state.R(2, 2)));
    result_.max_tilt_rad = std::max(result_.max_tilt_rad, tilt);
    result_.max_offset_m = std::max(result_.max_offset_m, truth_.state.p.head<2>().norm());
    result_.max_height_m = std::max(result_.max_height_m, truth_.state.p.z());
    attitude_sum_ += (std::pow(attitude_.attitude().roll - angles.roll, 2) +
                      std::pow(attitude_.attitude().pitch - angles.pitch, 2)) /
                     2.0;
    ++attitude_samples_;
    if (output_.phase == Phase::kHover) {
      hover_sum_ += (truth_.state.p - output_.set_point_m).squaredNorm();
      ++hover_samples_;
    }
    if (!result_.reached_height_s && truth_.state.p.z() > config_.script.front().position_m.z() - 0.05) {
      result_.reached_height_s = time_.ToSeconds(tick_);
    }
    Log(angles);
  }

  void Log(const models::TaitBryan& angles) const {
    if (config_.log == nullptr || tick_ % 24 != 0) return;
    const auto& s = truth_.state;
    const auto& m = output_.motion;
    *config_.log << time_.ToSeconds(tick_) << ',' << controller::Name(output_.phase) << ',' << s.p.x() << ',' << s.p.y()
                 << ',' << s.p.z() << ',' << s.v.x() << ',' << s.v.z() << ',' << m.p_WB.x() << ',' << m.p_WB.y() << ','
                 << m.p_WB.z() << ',' << m.v_WB.x() << ',' << m.v_WB.z() << ',' << output_.set_point_m.z() << ','
                 << angles.roll << ',' << angles.pitch << ',' << angles.yaw << ',' << attitude_.attitude().pitch << ','
                 << output_.attitude_set_point.pitch << ',' << output_.thrust_n << '\n';
  }

  void RecordTouchdown(double sink_rate) {
    const bool landing =
        output_.phase == Phase::kLanding || output_.phase == Phase::kBlindDescent || output_.phase == Phase::kTouchdown;
    if (landing && truth_.contact() && !result_.touchdown.has_value()) {
      const double tilt = std::acos(std::min(1.0, truth_.state.R(2, 2)));
      const double yaw = models::WrapToHalfPi(models::TaitBryanFromRotation(truth_.state.R).yaw);
      result_.touchdown = {truth_.state.p.head<2>().norm(), sink_rate, tilt, yaw, 0.0};
      contact_ = tick_;
    }
    if (result_.touchdown && motors_off_ && *motors_off_ == tick_) {
      result_.touchdown->motors_off_after_s = time_.ToSeconds(*motors_off_ - contact_);
    }
    if (truth_.state.R(2, 2) < 0.5 || truth_.state.p.norm() > 6.0) result_.crashed = true;
    if (landing && result_.touchdown && motors_off_ && *motors_off_ < contact_) {
      result_.touchdown->motors_off_after_s = time_.ToSeconds(*motors_off_ - contact_);
    }
  }

  bool IsOver() const {
    return result_.crashed || output_.phase == Phase::kGaveUp ||
           (output_.phase == Phase::kHover && output_.script_done) ||
           (motors_off_ && tick_ > *motors_off_ + time_.FromSeconds(0.5));
  }

  const RigConfig& config_;
  models::TimeBase time_;
  QuadrotorOde truth_;
  VisionModel vision_;
  ImuModel imu_;
  estimator::AttitudeEstimator attitude_;
  estimator::PoseFilter filter_;
  controller::FlightController controller_;

  Tick tick_ = 0;
  std::deque<VisionModel::Measurement> pending_;
  controller::ControlOutput output_;
  RigResult result_;
  Tick landing_start_ = 0, contact_ = 0;
  std::optional<Tick> motors_off_;
  double hover_sum_ = 0.0, attitude_sum_ = 0.0;
  int hover_samples_ = 0, attitude_samples_ = 0;
};

}  // namespace

RigResult Fly(const RigConfig& config) { return Rig(config).Fly(); }

controller::Maneuver TakeoffTo(double height_m) {
  return {.kind = controller::ManeuverKind::kTakeoff, .position_m = {0.0, 0.0, height_m}, .duration_s = 0.0};
}

controller::Maneuver HoverAt(const Vector3d& position_m, double duration_s) {
  return {.kind = controller::ManeuverKind::kHover, .position_m = position_m, .duration_s = duration_s};
}

controller::Maneuver Land() { return {.kind = controller::ManeuverKind::kLand, .position_m = {}, .duration_s = 0.0}; }

}  // namespace touchdown::tests
