#include "estimator/pad/outlier_gate.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator::pad {
namespace {

const Eigen::Vector3d kStart_p_WB(0.0, 0.0, 0.3);

double AngleBetweenVerticals(const Eigen::Matrix3d& R_WA, const Eigen::Matrix3d& R_WB) {
  return models::AngleBetween(R_WA.row(2), R_WB.row(2));
}

}  // namespace

void OutlierGateConfig::Validate() const {
  for (const double value :
       {max_speed_m_s, gate_m, gate_per_distance, max_tilt_rate_rad_s, gate_rad, start_gate_m, start_gate_rad}) {
    if (!std::isfinite(value) || value <= 0.0)
      throw InputError("the limits of the outlier gate must be positive and finite");
  }
  if (agreeing_outliers <= 0) throw InputError("agreeing_outliers must be at least 1");
}

OutlierGate::OutlierGate(const OutlierGateConfig& config, const models::TimeBase& time, FrameOrder frame_order)
    : config_(config), time_(time), frame_order_(frame_order) {
  config_.Validate();
}

bool OutlierGate::Agrees(const Reference& reference, models::Tick tick, const Eigen::Isometry3d& X_WB) const {
  const double dt = time_.ToSeconds(tick - reference.tick);
  const double distance = std::max(X_WB.translation().norm(), reference.X_WB.translation().norm());
  const double gate_limit_m = config_.gate_m + config_.gate_per_distance * distance + config_.max_speed_m_s * dt;
  return (X_WB.translation() - reference.X_WB.translation()).norm() <= gate_limit_m &&
         AngleBetweenVerticals(X_WB.linear(), reference.X_WB.linear()) <=
             config_.gate_rad + config_.max_tilt_rate_rad_s * dt;
}

bool OutlierGate::IsPlausibleStart(const Eigen::Isometry3d& X_WB) const {
  if (frame_order_ != FrameOrder::kFlight) return true;
  return (X_WB.translation() - kStart_p_WB).norm() <= config_.start_gate_m &&
         AngleBetweenVerticals(X_WB.linear(), Eigen::Matrix3d::Identity()) <= config_.start_gate_rad;
}

bool OutlierGate::Accepts(models::Tick tick, const Eigen::Isometry3d& X_WB) {
  if (frame_order_ == FrameOrder::kUnrelated) return true;
  bool accepted = accepted_ ? Agrees(*accepted_, tick, X_WB) : IsPlausibleStart(X_WB);
  if (!accepted) {
    candidate_count_ = candidate_ && Agrees(*candidate_, tick, X_WB) ? candidate_count_ + 1 : 1;
    candidate_ = Reference{tick, X_WB};
    accepted = candidate_count_ >= config_.agreeing_outliers;
  }
  if (accepted) {
    accepted_ = Reference{tick, X_WB};
    candidate_.reset();
    candidate_count_ = 0;
  }
  return accepted;
}

}  // namespace touchdown::estimator::pad
