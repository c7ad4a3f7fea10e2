#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "models/describe.h"
#include "scenarios/runner/events/event_effects.h"

namespace touchdown::runner {

struct Scenario;

/// A constant force and torque on the vehicle, for a while.
struct Push {
  static constexpr std::string_view kName = "push";
  static constexpr std::string_view kDoc = "a force and a torque";
  static constexpr bool kHasDuration = true;

  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();

  void Describe(models::ConfigVisitor& v);
  void Check(const Scenario& scenario, double duration_s) const;
  std::string Label() const;
  void Apply(const EventTime& time, EventEffects& effects) const;
};

}  // namespace touchdown::runner
