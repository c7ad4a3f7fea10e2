#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <string_view>

#include "models/landing_pad.h"
#include "scenarios/training/classifier_network.h"
#include "scenarios/training/classifier_samples.h"

namespace touchdown::training {

inline constexpr int kClasses = 3;

/// Name of a class: "circle", "h" ("rectangle" for a rectangle pad) or "other".
std::string_view ClassName(estimator::paper::ComponentClass label, models::PadLetter letter);

/// Class with the largest posterior of the network.
estimator::paper::ComponentClass PredictLabel(const Perceptron& network, const estimator::paper::Pattern& pattern);

/// Number of patterns by true class (row) and predicted class (column), in the order of ComponentClass.
struct ConfusionMatrix {
  std::array<std::array<int, kClasses>, kClasses> count{};

  int Total(int true_class) const;
  /// Fraction of the patterns of a class that are predicted correctly; 1 when there are none.
  double Recall(int true_class) const;
  /// Fraction of the patterns of other classes that are predicted as this class: p1 and p2 of Sec. IV-A.4.
  double FalsePositiveRate(int predicted_class) const;
};

/// Confusion matrix of a network for labeled patterns.
ConfusionMatrix ComputeConfusion(const Perceptron& network, std::span<const LabeledPattern> patterns);

/// Text table of the confusion matrix of a network for pads with this letter.
std::string ToText(const ConfusionMatrix& matrix, models::PadLetter letter);
/// The confusion matrix as JSON.
std::string ToJson(const ConfusionMatrix& matrix, models::PadLetter letter);

/// Image with the first patterns of a class, enlarged, in a grid of `columns` x `rows`.
cv::Mat1b PatternSheet(std::span<const LabeledPattern> patterns, estimator::paper::ComponentClass label, int columns,
                       int rows);

}  // namespace touchdown::training
