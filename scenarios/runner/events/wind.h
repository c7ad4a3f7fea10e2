#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "models/describe.h"
#include "scenarios/runner/events/event_effects.h"

namespace touchdown::runner {

struct Scenario;

/// A permanent change of the mean wind.
struct Wind {
  static constexpr std::string_view kName = "wind";
  static constexpr std::string_view kDoc = "a new mean wind";
  static constexpr bool kHasDuration = false;

  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();

  void Describe(models::ConfigVisitor& v);
  void Check(const Scenario& /*scenario*/, double /*duration_s*/) const {}
  std::string Label() const;
  void Apply(const EventTime& time, EventEffects& effects) const;
};

}  // namespace touchdown::runner
