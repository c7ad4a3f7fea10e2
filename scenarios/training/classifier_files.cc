#include <array>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scenarios/training/classifier_code.h"
#include "scenarios/training/classifier_study.h"
#include "scenarios/util/platform.h"

namespace touchdown::training {
namespace {

using estimator::paper::ComponentClass;
using models::PadLetter;

constexpr std::array kLabels{ComponentClass::kCircle, ComponentClass::kH, ComponentClass::kOther};

std::string WeightsFile(PadLetter letter) {
  return letter == PadLetter::kRectangle ? "classifier_weights_rectangle.c" : "classifier_weights.c";
}

std::string PatternFile(ComponentClass label, PadLetter letter) {
  return std::string(ClassName(label, letter)) + ".png";
}

std::string Png(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

/// Grid of the images at half size.
cv::Mat3b ContactSheet(const std::vector<cv::Mat3b>& images) {
  constexpr int kColumns = 3;
  const cv::Size size = images.front().size() / 2;
  const int rows = (static_cast<int>(images.size()) + kColumns - 1) / kColumns;
  cv::Mat3b sheet(rows * size.height, kColumns * size.width, cv::Vec3b(128, 128, 128));
  for (int i = 0; i < static_cast<int>(images.size()); ++i) {
    const cv::Rect cell(cv::Point((i % kColumns) * size.width, (i / kColumns) * size.height), size);
    cv::resize(images[static_cast<std::size_t>(i)], sheet(cell), size, 0, 0, cv::INTER_AREA);
  }
  return sheet;
}

std::vector<std::pair<std::string, std::string>> Provenance(const ClassifierStudy& study) {
  std::vector<std::pair<std::string, std::string>> provenance = util::PlatformFacts();
  provenance.insert(provenance.begin(), {"seed", std::to_string(study.seed)});
  return provenance;
}

cv::Mat1b MisclassifiedSheet(const ClassifierStudy& study) {
  constexpr int kColumns = 24;
  cv::Mat sheet;
  for (const auto label : kLabels) {
    const cv::Mat1b part = PatternSheet(study.misclassified, label, kColumns, 4);
    sheet.empty() ? part.copyTo(sheet) : cv::vconcat(sheet, part, sheet);
    sheet.push_back(cv::Mat(4, sheet.cols, CV_8U, cv::Scalar(0)));
  }
  return sheet;
}

}  // namespace

std::vector<StudyFile> ClassifierFiles(const ClassifierStudy& study) {
  std::vector<StudyFile> files{
      {"confusion.json", ToJson(study.test, study.letter)},
      {"confusion.txt",
       "Test scenes\n" + ToText(study.test, study.letter) + "\nTraining set\n" + ToText(study.training, study.letter)},
      {WeightsFile(study.letter), ClassifierCode(study.network, study.letter, Provenance(study))},
      {"mistaken.png", Png(MisclassifiedSheet(study))},
  };
  for (const auto label : kLabels) {
    files.push_back({PatternFile(label, study.letter), Png(PatternSheet(study.test_patterns, label, 24, 12))});
  }
  if (!study.annotated_frames.empty()) files.push_back({"frames.png", Png(ContactSheet(study.annotated_frames))});
  return files;
}

std::vector<std::string> ClassifierFileNames(PadLetter letter) {
  std::vector<std::string> names{"confusion.json", "confusion.txt", WeightsFile(letter), "mistaken.png", "frames.png"};
  for (const auto label : kLabels) names.push_back(PatternFile(label, letter));
  return names;
}

}  // namespace touchdown::training
