#pragma once

#include <cstdint>

#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// Sample sizes of the experiments.
struct PaperPlan {
  int seeds = 10;                 ///< Number of flights of each kind, and of calibrations.
  int landings = 100;             ///< Number of independent landings.
  double hand_s = 45.0;           ///< Duration of the hand-held motion.
  double hover_s = 66.0;          ///< Duration of the disturbed hover, as in the paper.
  int outdoor_variant_seeds = 3;  ///< Number of flights with one condition removed; at most `seeds`.
  int recognition_scenes = 100;   ///< Number of random rooms.
  int recognition_frames = 50;    ///< Frames per room with the pad, and as many without it.
  int placements = 10;            ///< Placements of the vehicle for each cell of Fig. 10.
  int frames_per_placement = 60;
  int trade_frames = 24;            ///< Frames at each height for each pad radius.
  int ambiguity_views = 60;         ///< Views at each tilt.
  int condition_seeds = 3;          ///< Flights for each condition.
  double condition_hover_s = 10.0;  ///< Duration of the hover of the conditions.
  double condition_hand_s = 25.0;   ///< Duration of the hand-held motion of the conditions.

  /// Plan with few samples for every section. It takes a few minutes, for CI.
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

/// The vehicle of the experiments: its true mounting of camera and IMU, and its assumed calibration.
struct PaperVehicle {
  models::Vehicle truth;
  runner::Calibration calibration;  ///< Result of the calibrations of Sec. III-D.

  /// Sets vehicle and calibration of a scenario.
  void ApplyTo(runner::Scenario& scenario) const {
    scenario.vehicle = truth;
    scenario.calibration = calibration;
  }
};

}  // namespace touchdown::experiments
