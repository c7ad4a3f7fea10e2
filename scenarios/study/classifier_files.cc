#include <algorithm>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "models/error.h"
#include "scenarios/study/classifier_code.h"
#include "scenarios/study/classifier_study.h"

namespace touchdown::scenarios {
namespace {

using estimator::FrameTrace;

void WriteText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw InputError("cannot write " + path.string());
}

void WritePicture(const std::filesystem::path& path, const cv::Mat& picture) {
  bool written = false;
  try {
    written = cv::imwrite(path.string(), picture);
  } catch (const cv::Exception&) {
  }
  if (!written) throw InputError("cannot write " + path.string());
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

void WriteClassifierStudy(const ClassifierStudy& study, const std::filesystem::path& folder) {
  WriteText(folder / "classifier_weights.c", ClassifierCode(study.network));
  WriteText(folder / "confusion.txt",
            "Scenes never trained on\n" + ToText(study.test) + "\nTraining set\n" + ToText(study.training));
  WriteText(folder / "confusion.json", ToJson(study.test));
  for (const auto label : {FrameTrace::Label::kCircle, FrameTrace::Label::kH, FrameTrace::Label::kOther}) {
    const cv::Mat1b sheet = PatternSheet(study.test_patterns, label, 24, 12);
    WritePicture(folder / (std::string(ClassName(label)) + ".png"), sheet);
  }
  WritePicture(folder / "mistaken.png", MistakenSheet(study));
  if (!study.pictures.empty()) WritePicture(folder / "frames.png", ContactSheet(study.pictures));
}

}  // namespace touchdown::scenarios
