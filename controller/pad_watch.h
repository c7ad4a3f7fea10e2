#pragma once

#include <optional>

#include "models/time.h"

namespace touchdown::controller {

/// Classifies the pad as lost, found or fresh from the times of its detections.
class PadWatch {
 public:
  struct Settings {
    models::Tick lost_after = 0;  ///< Time without a detection after which the pad is lost.
    /// Duration of detections, with gaps of at most lost_after, after which the pad is found.
    models::Tick found_after = 0;
    models::Tick fresh_for = 0;  ///< Largest age of a detection that is fresh.
  };

  explicit PadWatch(const Settings& settings) : settings_(settings) {}

  /// `pad_seen` is the mid-exposure of the newest frame whose pose was used; nullopt: none yet.
  void Update(models::Tick tick, std::optional<models::Tick> pad_seen);

  /// Whether the newest detection is too old for control, or absent.
  bool lost() const { return lost_; }
  /// Whether the pad is not lost and has been seen long enough for a reliable position and velocity.
  bool found() const { return found_; }
  /// Whether the newest detection is recent enough for an estimate that does not use commands.
  bool fresh() const { return fresh_; }

 private:
  Settings settings_;
  std::optional<models::Tick> newest_, since_;
  bool lost_ = true, found_ = false, fresh_ = false;
};

}  // namespace touchdown::controller
