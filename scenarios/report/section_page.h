#pragma once

#include <map>
#include <string>

#include "scenarios/report/section.h"

namespace touchdown::report {

/// Renders a section as HTML, without links to files. Throws the exceptions of Draw.
std::string SectionHtml(const ReportSection& section);

/// HTML of a section and the files to which it links.
struct SectionWithFiles {
  std::string html = {};
  /// File contents by path relative to the page, all in figures/: each figure as CSV, PDF and SVG, each image as JPEG,
  /// PDF and CSV, each table as CSV.
  std::map<std::string, std::string> files = {};
};

/// Renders a section with its files. Throws the exceptions of Draw.
SectionWithFiles DrawSection(const ReportSection& section);

}  // namespace touchdown::report
