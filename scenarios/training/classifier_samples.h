#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "estimator/paper/classifier.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/random_stream.h"
#include "scenarios/training/classifier_truth.h"
#include "scenarios/training/classifier_views.h"
#include "sim/render/camera_optics.h"

namespace touchdown::training {

/// A component as the classifier sees it, and what it is.
struct LabeledPattern {
  estimator::paper::Pattern pattern{};
  estimator::paper::ComponentClass label = estimator::paper::ComponentClass::kOther;
};

/// What one scene gives.
struct SceneSamplesConfig {
  models::PadLetter letter = models::PadLetter::kH;  ///< Of the scene's pad and of its lone letters.
  models::CameraModel camera;
  ViewConfig views;
  TruthConfig truth;
  int frames = 24;
  int lone_circles = 26;  ///< More decoys than a flight's scene has: each adds proportions of its own.
  int lone_letters = 28;
  int clutter_per_frame = 24;  ///< At most; drawn at random from the frame's.

  /// Throws InputError when a count is not positive or the views' settings are unusable.
  void Validate() const;
};

struct SceneSamples {
  std::vector<LabeledPattern> patterns;
  int unclear = 0;                          ///< Components left out since their truth is unclear.
  std::vector<cv::Mat3b> annotated_frames;  ///< The first frames, with each component's box in its label's color.
};

/// A landing pad of this letter, of proportions that somebody might print: half the time those of the default one.
models::LandingPad DrawPad(models::PadLetter letter, models::RandomStream& random);

/// Builds a scene from the seed, renders frames of it from many views, and binarizes, labels and classifies by the
/// truth. Four views in ten look for the pad, the others for a lone ring or letter. Among lone rectangles every third
/// is an H instead: clutter. The same seed gives the same samples. `optics` are config.camera's. `pictures` is how many
/// annotated frames to keep.
SceneSamples CollectSceneSamples(const SceneSamplesConfig& config, const sim::CameraOptics& optics, std::uint64_t seed,
                                 int annotated_count);

}  // namespace touchdown::training
