#pragma once

#include <string>
#include <vector>

#include "scenarios/report/figure.h"

namespace touchdown::report {

struct ReportTable {
  std::string name = {};     ///< Base name of its CSV file.
  std::string caption = {};  ///< HTML.
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
};

/// JPEG image of a report, included unchanged.
struct ReportImage {
  std::string name = {};  ///< Base name of its files.
  std::string title = {};
  std::string caption = {};
  std::string jpeg = {};
  std::string csv = {};  ///< Data that is drawn in the image.
};

/// Section of a report page: paragraphs, figures, images and tables.
struct ReportSection {
  std::string id = {};
  std::string title = {};
  std::vector<std::string> paragraphs = {};  ///< HTML.
  std::vector<Figure> figures = {};
  std::vector<ReportImage> images = {};
  std::vector<ReportTable> tables = {};
};

}  // namespace touchdown::report
