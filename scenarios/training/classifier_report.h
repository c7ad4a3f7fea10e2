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

/// "circle", "h" (or "rectangle") or "other".
std::string_view ClassName(estimator::paper::ComponentClass label, models::PadLetter letter);

/// The class of the network's largest posterior.
estimator::paper::ComponentClass PredictLabel(const Perceptron& network, const estimator::paper::Pattern& pattern);

/// How many patterns of each true class (row) were given each class (column), in the order of ComponentClass.
struct ConfusionMatrix {
  std::array<std::array<int, kClasses>, kClasses> count{};

  int Total(int true_class) const;
  /// Share of the true class that was given its own; 1 when there are none of it.
  double Recall(int true_class) const;
  /// Share of the other classes' patterns that were given `given_class`: p1 and p2 of Sec. IV-A.4.
  double FalsePositiveRate(int given_class) const;
};

ConfusionMatrix Confuse(const Perceptron& network, std::span<const LabeledPattern> patterns);

/// The matrix of a network for pads of this letter as a table for people ...
std::string ToText(const ConfusionMatrix& matrix, models::PadLetter letter);
/// ... and for programs.
std::string ToJson(const ConfusionMatrix& matrix, models::PadLetter letter);

/// The first patterns of a class as a sheet of `columns` x `rows` enlarged pictures.
cv::Mat1b PatternSheet(std::span<const LabeledPattern> patterns, estimator::paper::ComponentClass label, int columns,
                       int rows);

}  // namespace touchdown::training
