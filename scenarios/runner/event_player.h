#pragma once

#include <vector>

#include "models/time.h"
#include "scenarios/runner/scenario.h"
#include "sim/dynamics/world.h"

namespace touchdown::runner {

/// Makes a scenario's events happen, each from the tick nearest to its time on.
class EventPlayer {
 public:
  EventPlayer(std::vector<Event> events, const models::TimeBase& time);

  /// Sets what acts on the world at `tick`; call it once a tick, in order. Pushes that overlap add up; the newest wind
  /// blows.
  void Apply(models::Tick tick, sim::World& world);

  /// Whether the camera's frames are lost, and the pad covered, at the tick of the newest Apply.
  bool frames_are_lost() const { return effects_.frames_are_lost; }
  bool pad_is_covered() const { return effects_.pad_is_covered; }

 private:
  std::vector<Event> events_;
  models::TimeBase time_;
  EventEffects effects_;
};

}  // namespace touchdown::runner
