#pragma once

#include <vector>

#include "models/time.h"
#include "scenarios/runner/scenario.h"
#include "sim/dynamics/world.h"

namespace touchdown::runner {

/// Applies the events of a scenario, each from the tick nearest to its start.
class EventPlayer {
 public:
  EventPlayer(std::vector<Event> events, const models::TimeBase& time);

  /// Applies the effects at `tick` to the world. Call once per tick, in order. Overlapping pushes add up; the newest
  /// wind replaces earlier ones.
  void Apply(models::Tick tick, sim::World& world);

  /// Effects on frames and pad at the tick of the newest Apply.
  bool frames_are_lost() const { return effects_.frames_are_lost; }
  bool pad_is_covered() const { return effects_.pad_is_covered; }

 private:
  std::vector<Event> events_;
  models::TimeBase time_;
  EventEffects effects_;
};

}  // namespace touchdown::runner
