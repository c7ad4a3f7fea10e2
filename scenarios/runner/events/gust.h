#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "models/describe.h"
#include "scenarios/runner/events/event_effects.h"

namespace touchdown::runner {

struct Scenario;

/// A discrete gust with the profile of EASA CS-25.341(a)(2): v(t) = peak_velocity_m_s (1 - cos(2 pi t / duration_s)) /
/// 2 is added to the mean wind.
struct Gust {
  static constexpr std::string_view kName = "gust";
  static constexpr std::string_view kDoc = "a 1-cosine gust on top of the mean wind";
  static constexpr bool kHasDuration = true;

  Eigen::Vector3d peak_velocity_m_s = Eigen::Vector3d::Zero();  ///< At its peak, in W.

  void Describe(models::ConfigVisitor& v);
  void Check(const Scenario& scenario, double duration_s) const;
  std::string Label() const;
  void Apply(const EventTime& time, EventEffects& effects) const;
};

}  // namespace touchdown::runner
