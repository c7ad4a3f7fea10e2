#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/experiments/experiment.h"

namespace touchdown::experiments {

/// What the report tells of itself.
struct ReportHead {
  std::string mark = {};  ///< By which the page is known again.
  bool quick = false;
  std::string command = {};
  std::vector<std::pair<std::string, std::string>> platform = {};
};

/// The report's files by their names within its folder: report.html, README.md (the summary, and the figures as
/// pictures), summary.csv, and in figures/ each figure as CSV, PDF and SVG, each table as CSV and each picture.
/// Throws as Draw does.
std::map<std::string, std::string> ReportFiles(const ReportHead& head, const std::vector<PaperSection>& sections);

}  // namespace touchdown::experiments
