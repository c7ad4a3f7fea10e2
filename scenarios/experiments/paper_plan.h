#pragma once

#include <cstdint>

#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// How much is measured.
struct PaperPlan {
  int seeds = 10;  ///< Flights of each kind, and calibrations.
  int landings = 100;
  double hand_s = 45.0;           ///< Length of the hand-held motion.
  double hover_s = 66.0;          ///< And of the disturbed hover, as the paper's.
  int outdoor_variant_seeds = 3;  ///< With one condition taken away; not more than `seeds`.
  int recognition_scenes = 100;
  int recognition_frames = 50;  ///< A scene, with the pad, and as many without it.
  int placements = 10;          ///< For each cell of Fig. 10 ...
  int frames_per_placement = 60;
  int trade_frames = 24;     ///< At each height, for each radius.
  int ambiguity_views = 60;  ///< At each tilt.
  int condition_seeds = 3;
  double condition_hover_s = 10.0;
  double condition_hand_s = 25.0;

  /// A few minutes, for CI: every section, on fewer samples.
  static PaperPlan Quick() {
    return {.seeds = 1,
            .landings = 3,
            .hand_s = 10.0,
            .hover_s = 5.0,
            .outdoor_variant_seeds = 0,
            .recognition_scenes = 4,
            .recognition_frames = 25,
            .placements = 2,
            .frames_per_placement = 6,
            .trade_frames = 4,
            .ambiguity_views = 6,
            .condition_seeds = 1,
            .condition_hover_s = 1.0,
            .condition_hand_s = 10.0};
  }
};

/// The vehicle that is flown: how its camera and IMU are mounted, and what is known of it.
struct PaperVehicle {
  models::Vehicle truth;
  runner::Calibration calibration;  ///< As the paper's calibrations found it.

  /// Puts it into a scenario.
  void Equip(runner::Scenario& scenario) const {
    scenario.vehicle = truth;
    scenario.calibration = calibration;
  }
};

}  // namespace touchdown::experiments
