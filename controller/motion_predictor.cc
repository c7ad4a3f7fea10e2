#include "controller/motion_predictor.h"

#include <algorithm>
#include <cmath>

namespace touchdown::controller {

MotionPredictor::MotionPredictor(const models::Vehicle& vehicle, double period_s, double thrust_n)
    : mass_kg_(vehicle.mass_kg),
      period_s_(period_s),
      lag_(1.0 - std::exp(-period_s / vehicle.rotor.time_constant_s)),
      thrust_n_(thrust_n) {}

void MotionPredictor::Step(const models::TaitBryan& attitude, double thrust_n, const Eigen::Vector3d& trim_m_s2) {
  thrust_n_ += lag_ * (thrust_n - thrust_n_);
  const Eigen::Vector3d acceleration = thrust_n_ / mass_kg_ * models::RotationFromTaitBryan(attitude).col(2) -
                                       models::kGravity_m_s2 * Eigen::Vector3d::UnitZ() - trim_m_s2;
  motion_.p_WB += period_s_ * (motion_.v_WB + 0.5 * period_s_ * acceleration);
  motion_.v_WB += period_s_ * acceleration;
}

void MotionPredictor::StandAt(double height_m) {
  if (motion_.p_WB.z() > height_m) return;
  motion_.p_WB.z() = height_m;
  motion_.v_WB.head<2>().setZero();
  motion_.v_WB.z() = std::max(0.0, motion_.v_WB.z());
}

}  // namespace touchdown::controller
