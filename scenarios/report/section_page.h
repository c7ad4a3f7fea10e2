#pragma once

#include <map>
#include <string>

#include "scenarios/report/section.h"

namespace touchdown::report {

/// A section as a part of a page.
std::string SectionHtml(const ReportSection& section);

/// A section as a part of a page with files beside it.
struct SectionWithFiles {
  std::string html = {};  ///< It links to the files.
  /// By their names within the page's folder, in figures/: each figure as CSV, PDF and SVG, each picture as JPEG, PDF
  /// and CSV, each table as CSV.
  std::map<std::string, std::string> files = {};
};

/// Both throw as Draw does.
SectionWithFiles DrawSection(const ReportSection& section);

}  // namespace touchdown::report
