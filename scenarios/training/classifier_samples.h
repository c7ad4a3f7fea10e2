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

/// Input pattern of the classifier and its true class.
struct LabeledPattern {
  estimator::paper::Pattern pattern{};
  estimator::paper::ComponentClass label = estimator::paper::ComponentClass::kOther;
};

/// Settings for the samples of one scene.
struct SceneSamplesConfig {
  models::PadLetter letter = models::PadLetter::kH;  ///< Letter of the pad and of the lone letters.
  models::CameraModel camera;
  ViewConfig views;
  TruthConfig truth;
  int frames = 24;
  int lone_circles = 26;  ///< Distractors; more than in a flight's scene, because each has its own proportions.
  int lone_letters = 28;
  int clutter_per_frame = 24;  ///< Maximum number of clutter components, selected at random from a frame.

  /// Throws InputError when a count is not positive, or the camera or the view settings are invalid.
  void Validate() const;
};

struct SceneSamples {
  std::vector<LabeledPattern> patterns;
  int unclear = 0;                          ///< Number of components excluded because their true class is unclear.
  std::vector<cv::Mat3b> annotated_frames;  ///< First frames, with component boxes colored by label.
};

/// Draws a landing pad with this letter: default dimensions with probability 0.5, else random plausible proportions.
models::LandingPad DrawPad(models::PadLetter letter, models::RandomStream& random);

/// Builds a random scene, renders frames from random views, and labels the components of each binarized frame with
/// their true classes. A view aims at the ring of the pad with probability 0.4, else at another ring or letter. For
/// rectangle pads, every third lone rectangle is replaced by an H, which is clutter. The same seed gives the same
/// samples. `optics` must belong to config.camera. `annotated_count` is the number of annotated frames to keep.
SceneSamples CollectSceneSamples(const SceneSamplesConfig& config, const sim::CameraOptics& optics, std::uint64_t seed,
                                 int annotated_count);

}  // namespace touchdown::training
