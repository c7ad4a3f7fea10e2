#pragma once

#include <string>
#include <variant>

#include "models/describe.h"
#include "scenarios/runner/events/cover_pad.h"
#include "scenarios/runner/events/gust.h"
#include "scenarios/runner/events/lose_frames.h"
#include "scenarios/runner/events/push.h"
#include "scenarios/runner/events/wind.h"

namespace touchdown::runner {

/// Every kind of event. A new kind is a file in this folder with a struct of this form, and its name here:
///
///     static constexpr std::string_view kName, kDoc;  // Value of the key `do`, and its meaning.
///     static constexpr bool kHasDuration;             // Whether it ends after the key `duration_s`.
///     void Describe(models::ConfigVisitor& v);        // Keys of its own.
///     void Check(const Scenario&, double duration_s) const;    // Throws InputError, e.g. for an event without effect.
///     std::string Label() const;                               // For the report.
///     void Apply(const EventTime& time, EventEffects& effects) const;  // At each tick at which it acts.
using EventKind = std::variant<Push, Wind, Gust, CoverPad, LoseFrames>;

/// Something that happens to the vehicle or its surroundings during a flight.
struct Event {
  EventKind kind = {};
  double at_s = 0.0;
  double duration_s = 0.0;  ///< Not used by kinds without a duration.

  /// Throws InputError for an event that has no effect in `scenario`.
  void Check(const Scenario& scenario) const;
  std::string Label() const;
  bool has_duration() const;
};

void Describe(models::ConfigVisitor& v, Event& event);

}  // namespace touchdown::runner
