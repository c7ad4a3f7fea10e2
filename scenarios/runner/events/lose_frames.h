#pragma once

#include <string>
#include <string_view>

#include "models/describe.h"
#include "scenarios/runner/events/event_effects.h"

namespace touchdown::runner {

struct Scenario;

/// Camera frames that do not arrive, for a while.
struct LoseFrames {
  static constexpr std::string_view kName = "lose_frames";
  static constexpr std::string_view kDoc = "lost camera frames";
  static constexpr bool kHasDuration = true;

  void Describe(models::ConfigVisitor& /*v*/) {}
  void Check(const Scenario& scenario, double duration_s) const;
  std::string Label() const { return "frames lost"; }
  void Apply(const EventTime& /*time*/, EventEffects& effects) const { effects.frames_are_lost = true; }
};

}  // namespace touchdown::runner
