#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/training/classifier_report.h"
#include "scenarios/training/classifier_samples.h"
#include "scenarios/training/classifier_training.h"

namespace touchdown::training {

/// Settings of the classifier's training (Sec. IV-A.3). Training, validation and test use different scenes. The
/// validation scenes select the best epoch.
struct ClassifierStudyConfig {
  SceneSamplesConfig scene;
  int training_scenes = 60;
  int validation_scenes = 10;
  int test_scenes = 40;
  int circles = 3000;             ///< Maximum number of circles in the training set.
  int letters = 3000;             ///< Maximum number of letters in the training set.
  int clutter = 7000;             ///< Maximum number of clutter patterns in the training set.
  double hard_clutter = 0.2;      ///< Fraction of the clutter that a first network classifies worst.
  int first_network_epochs = 20;  ///< Epochs of the first network, which serves only to find the hard clutter.
  TrainingConfig training;

  /// Settings of the compiled-in network for this letter. The study of the rectangle uses fewer scenes and epochs.
  static ClassifierStudyConfig For(models::PadLetter letter);

  /// Throws InputError when a count is not positive or a fraction is outside [0, 1].
  void Validate() const;
};

/// Called after each scene and each epoch with a description and the completed fraction, 0 to 1.
using StudyProgress = std::function<void(const std::string& text, double fraction)>;

/// Result of training and test.
struct ClassifierStudy {
  models::PadLetter letter = models::PadLetter::kH;
  std::uint64_t seed = 0;
  Perceptron network;
  ConfusionMatrix training;
  ConfusionMatrix test;
  std::vector<LabeledPattern> test_patterns;
  std::vector<LabeledPattern> misclassified;  ///< Test patterns that the network misclassifies.
  std::vector<cv::Mat3b> annotated_frames;    ///< Frames of the test scenes, with boxes colored by true class.
  int unclear = 0;                            ///< Number of test components excluded as unclear.
};

/// Renders the scenes, and trains and tests the network. The same config and seed give a bit-identical network on the
/// same type of CPU. `progress` may be null; it may throw to stop.
ClassifierStudy StudyClassifier(const ClassifierStudyConfig& config, std::uint64_t seed,
                                const StudyProgress& progress = {});

/// Name and content of an output file.
struct StudyFile {
  std::string name;
  std::string content;
};

/// Output files of a study: confusion.json, confusion.txt, classifier_weights.c (classifier_weights_rectangle.c), and
/// the images circle.png, h.png (rectangle.png) and other.png (test patterns of each class), mistaken.png
/// (misclassified test patterns: circles, letters, others) and frames.png (annotated frames).
std::vector<StudyFile> ClassifierFiles(const ClassifierStudy& study);

/// Names of the files of ClassifierFiles.
std::vector<std::string> ClassifierFileNames(models::PadLetter letter);

}  // namespace touchdown::training
