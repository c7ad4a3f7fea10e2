#pragma once

#include <optional>

#include "models/time.h"

namespace touchdown::controller {

/// Keeps count of when the pad was seen.
class PadWatch {
 public:
  struct Settings {
    models::Tick lost_after = 0;   ///< Without a sighting.
    models::Tick found_after = 0;  ///< Of sightings, none of them later than lost_after upon the one before.
    models::Tick fresh_for = 0;
  };

  explicit PadWatch(const Settings& settings) : settings_(settings) {}

  /// `pad_seen` is the mid-exposure of the newest frame whose pose was used; nullopt: none yet.
  void Update(models::Tick tick, std::optional<models::Tick> pad_seen);

  /// Whether the newest sighting is too old to fly by, or there is none.
  bool lost() const { return lost_; }
  /// Whether the pad is not lost and has been seen for long enough for position and velocity to be relied on.
  bool found() const { return found_; }
  /// Whether the newest sighting is young enough for an estimate that knows nothing of what was commanded since.
  bool fresh() const { return fresh_; }

 private:
  Settings settings_;
  std::optional<models::Tick> newest_, since_;
  bool lost_ = true, found_ = false, fresh_ = false;
};

}  // namespace touchdown::controller
