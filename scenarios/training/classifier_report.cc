#include "scenarios/training/classifier_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <opencv2/imgproc.hpp>

namespace touchdown::training {
namespace {

using estimator::paper::ComponentClass;
using models::PadLetter;

std::array<std::string_view, kClasses> NamesFor(PadLetter letter) {
  return {"circle", letter == PadLetter::kRectangle ? "rectangle" : "h", "other"};
}

}  // namespace

std::string_view ClassName(ComponentClass label, PadLetter letter) {
  return NamesFor(letter)[static_cast<std::size_t>(label)];
}

ComponentClass PredictLabel(const Perceptron& network, const estimator::paper::Pattern& pattern) {
  const std::vector<double> posterior = network.Posteriors(pattern);
  return static_cast<ComponentClass>(std::max_element(posterior.begin(), posterior.end()) - posterior.begin());
}

int ConfusionMatrix::Total(int true_class) const {
  const auto& row = count[static_cast<std::size_t>(true_class)];
  return std::accumulate(row.begin(), row.end(), 0);
}

double ConfusionMatrix::Recall(int true_class) const {
  const int total = Total(true_class);
  const auto i = static_cast<std::size_t>(true_class);
  return total == 0 ? 1.0 : static_cast<double>(count[i][i]) / total;
}

double ConfusionMatrix::FalsePositiveRate(int predicted_class) const {
  int wrong = 0, total = 0;
  for (int i = 0; i < kClasses; ++i) {
    if (i == predicted_class) continue;
    wrong += count[static_cast<std::size_t>(i)][static_cast<std::size_t>(predicted_class)];
    total += Total(i);
  }
  return total == 0 ? 0.0 : static_cast<double>(wrong) / total;
}

ConfusionMatrix ComputeConfusion(const Perceptron& network, std::span<const LabeledPattern> patterns) {
  ConfusionMatrix matrix;
  for (const LabeledPattern& sample : patterns) {
    const auto predicted = static_cast<std::size_t>(PredictLabel(network, sample.pattern));
    ++matrix.count[static_cast<std::size_t>(sample.label)][predicted];
  }
  return matrix;
}

std::string ToText(const ConfusionMatrix& matrix, PadLetter letter) {
  const auto names = NamesFor(letter);
  std::string text =
      fmt::format("{:<14}{:>10}{:>10}{:>10}{:>10}\n", "true\\predicted", names[0], names[1], names[2], "recall");
  for (int i = 0; i < kClasses; ++i) {
    const auto& row = matrix.count[static_cast<std::size_t>(i)];
    text += fmt::format("{:<14}{:>10}{:>10}{:>10}{:>9.2f}%\n", names[static_cast<std::size_t>(i)], row[0], row[1],
                        row[2], 100.0 * matrix.Recall(i));
  }
  text += fmt::format("False positives: {} {:.3f}%, {} {:.3f}%\n", names[0], 100.0 * matrix.FalsePositiveRate(0),
                      names[1], 100.0 * matrix.FalsePositiveRate(1));
  return text;
}

std::string ToJson(const ConfusionMatrix& matrix, PadLetter letter) {
  const auto names = NamesFor(letter);
  nlohmann::ordered_json json{{"schema", "touchdown.classifier"}, {"version", 1}};
  for (int i = 0; i < kClasses; ++i) {
    const std::string name(names[static_cast<std::size_t>(i)]);
    for (int j = 0; j < kClasses; ++j) {
      const std::string predicted(names[static_cast<std::size_t>(j)]);
      json["given"][name][predicted] = matrix.count[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    json["right"][name] = matrix.Recall(i);
    json["false_positive_rate"][name] = matrix.FalsePositiveRate(i);
  }
  return json.dump(2) + "\n";
}

cv::Mat1b PatternSheet(std::span<const LabeledPattern> patterns, ComponentClass label, int columns, int rows) {
  constexpr int kScale = 3, kPitch = estimator::paper::kPatternSide * kScale + 4;
  cv::Mat1b sheet(rows * kPitch, columns * kPitch, std::uint8_t{128});
  int placed = 0;
  for (const LabeledPattern& sample : patterns) {
    if (sample.label != label || placed == columns * rows) continue;
    cv::Mat1b small(estimator::paper::kPatternSide, estimator::paper::kPatternSide);
    std::transform(sample.pattern.begin(), sample.pattern.end(), small.begin(),
                   [](float cell) { return cv::saturate_cast<std::uint8_t>(255.0F * (1.0F - cell)); });
    const cv::Rect cell((placed % columns) * kPitch + 2, (placed / columns) * kPitch + 2, kPitch - 4, kPitch - 4);
    cv::resize(small, sheet(cell), cell.size(), 0, 0, cv::INTER_NEAREST);
    ++placed;
  }
  return sheet;
}

}  // namespace touchdown::training
