#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scenarios/flight/platform.h"
#include "scenarios/study/classifier_code.h"
#include "scenarios/study/classifier_study.h"

namespace touchdown::scenarios {
namespace {

using estimator::FrameTrace;

std::string Png(const cv::Mat& picture) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", picture, bytes);
  return {bytes.begin(), bytes.end()};
}

/// The pictures at half size, side by side.
cv::Mat3b ContactSheet(const std::vector<cv::Mat3b>& pictures) {
  constexpr int kColumns = 3;
  const cv::Size size = pictures.front().size() / 2;
  const int rows = (static_cast<int>(pictures.size()) + kColumns - 1) / kColumns;
  cv::Mat3b sheet(rows * size.height, kColumns * size.width, cv::Vec3b(128, 128, 128));
  for (int i = 0; i < static_cast<int>(pictures.size()); ++i) {
    const cv::Rect place(cv::Point((i % kColumns) * size.width, (i / kColumns) * size.height), size);
    cv::resize(pictures[static_cast<std::size_t>(i)], sheet(place), size, 0, 0, cv::INTER_AREA);
  }
  return sheet;
}

std::vector<std::pair<std::string, std::string>> Provenance(const ClassifierStudy& study) {
  std::vector<std::pair<std::string, std::string>> provenance = PlatformFacts();
  provenance.insert(provenance.begin(), {"seed", std::to_string(study.seed)});
  return provenance;
}

cv::Mat1b MistakenSheet(const ClassifierStudy& study) {
  constexpr int kColumns = 24;
  cv::Mat sheet;
  for (const auto label : {FrameTrace::Label::kCircle, FrameTrace::Label::kH, FrameTrace::Label::kOther}) {
    const cv::Mat1b part = PatternSheet(study.mistaken, label, kColumns, 4);
    sheet.empty() ? part.copyTo(sheet) : cv::vconcat(sheet, part, sheet);
    sheet.push_back(cv::Mat(4, sheet.cols, CV_8U, cv::Scalar(0)));
  }
  return sheet;
}

}  // namespace

std::vector<StudyFile> ClassifierFiles(const ClassifierStudy& study) {
  std::vector<StudyFile> files{
      {"confusion.json", ToJson(study.test)},
      {"confusion.txt", "Scenes never trained on\n" + ToText(study.test) + "\nTraining set\n" + ToText(study.training)},
      {"classifier_weights.c", ClassifierCode(study.network, Provenance(study))},
      {"mistaken.png", Png(MistakenSheet(study))},
  };
  for (const auto label : {FrameTrace::Label::kCircle, FrameTrace::Label::kH, FrameTrace::Label::kOther}) {
    files.push_back({std::string(ClassName(label)) + ".png", Png(PatternSheet(study.test_patterns, label, 24, 12))});
  }
  if (!study.pictures.empty()) files.push_back({"frames.png", Png(ContactSheet(study.pictures))});
  return files;
}

}  // namespace touchdown::scenarios
