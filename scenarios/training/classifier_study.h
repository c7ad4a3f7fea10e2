#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/training/classifier_report.h"
#include "scenarios/training/classifier_samples.h"
#include "scenarios/training/classifier_training.h"

namespace touchdown::training {

/// The classifier's experiment (Sec. IV-A.3): scenes to learn from, scenes to stop the training by, and scenes to test
/// on. No scene belongs to two of the three.
struct ClassifierStudyConfig {
  SceneSamplesConfig scene;
  int training_scenes = 60;
  int validation_scenes = 10;
  int test_scenes = 40;
  int circles = 3000;  ///< Of the training set, at most, as for the other two.
  int letters = 3000;
  int clutter = 7000;
  double hard_clutter = 0.2;  ///< Share of the clutter that a first network found hardest to tell from circle and H.
  int first_network_epochs = 20;
  TrainingConfig training;

  /// The settings with which the compiled-in network of this letter was trained. The rectangle's study is smaller.
  static ClassifierStudyConfig For(models::PadLetter letter);

  /// Throws InputError when a count is not positive or a share is outside [0, 1].
  void Validate() const;
};

/// Told after each scene and each epoch: what was done, and the share of the whole that is done with it, in [0, 1].
using StudyProgress = std::function<void(const std::string& text, double fraction)>;

struct ClassifierStudy {
  models::PadLetter letter = models::PadLetter::kH;
  std::uint64_t seed = 0;
  Perceptron network;
  ConfusionMatrix training;
  ConfusionMatrix test;
  std::vector<LabeledPattern> test_patterns;
  std::vector<LabeledPattern> misclassified;  ///< Those of the test that the network gets wrong.
  std::vector<cv::Mat3b> annotated_frames;    ///< Frames of the test scenes, boxes colored by the truth.
  int unclear = 0;                            ///< Test components left out since their truth is unclear.
};

/// Renders, trains and tests. The same config and seed give the same network, bit for bit, on the same type of CPU.
/// `progress` may throw to stop.
ClassifierStudy StudyClassifier(const ClassifierStudyConfig& config, std::uint64_t seed,
                                const StudyProgress& progress = {});

/// A file to write.
struct StudyFile {
  std::string name;
  std::string content;
};

/// The study's files: confusion.json, confusion.txt, classifier_weights.c (classifier_weights_rectangle.c), and the
/// pictures circle.png, h.png (rectangle.png), other.png (test patterns of each class), mistaken.png (those the network
/// gets wrong: circles, letters, others) and frames.png.
std::vector<StudyFile> ClassifierFiles(const ClassifierStudy& study);

/// The names of ClassifierFiles.
std::vector<std::string> ClassifierFileNames(models::PadLetter letter);

}  // namespace touchdown::training
