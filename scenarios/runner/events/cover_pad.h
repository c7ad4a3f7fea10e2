#pragma once

#include <string>
#include <string_view>

#include "models/describe.h"
#include "scenarios/runner/events/event_effects.h"

namespace touchdown::runner {

struct Scenario;

/// A plain sheet over the pad, for a while.
struct CoverPad {
  static constexpr std::string_view kName = "cover_pad";
  static constexpr std::string_view kDoc = "a plain sheet over the pad";
  static constexpr bool kHasDuration = true;

  void Describe(models::ConfigVisitor& /*v*/) {}
  void Check(const Scenario& scenario, double duration_s) const;
  std::string Label() const { return "pad covered"; }
  void Apply(const EventTime& /*time*/, EventEffects& effects) const { effects.pad_is_covered = true; }
};

}  // namespace touchdown::runner
