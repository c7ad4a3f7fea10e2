#pragma once

#include <string>
#include <vector>

#include "scenarios/report/figure.h"

namespace touchdown::report {

struct ReportTable {
  std::string name = {};     ///< Of its CSV file.
  std::string caption = {};  ///< HTML.
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
};

/// A picture, as it is, beside the drawn figures.
struct ReportPicture {
  std::string name = {};  ///< Of its file, without ending.
  std::string title = {};
  std::string caption = {};
  std::string jpeg = {};
  std::string csv = {};  ///< What is drawn into it, as numbers.
};

/// A section of a page: words, figures, pictures and tables.
struct ReportSection {
  std::string id = {};
  std::string title = {};
  std::vector<std::string> paragraphs = {};  ///< HTML.
  std::vector<Figure> figures = {};
  std::vector<ReportPicture> pictures = {};
  std::vector<ReportTable> tables = {};
};

}  // namespace touchdown::report
