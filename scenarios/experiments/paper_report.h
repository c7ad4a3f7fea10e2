#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/experiments/experiment.h"

namespace touchdown::experiments {

/// Data for the head of the report.
struct ReportHead {
  std::string signature = {};  ///< Text by which an earlier report.html is recognized.
  bool quick = false;          ///< Marks the report as based on PaperPlan::Quick().
  std::string command = {};    ///< Command line that generates the report.
  std::vector<std::pair<std::string, std::string>> platform = {};
};

/// Files of the report by their paths relative to its directory: report.html, README.md (summary and figures),
/// summary.csv, and in figures/ each figure as CSV, PDF and SVG, each table as CSV and each image. Throws as
/// report::DrawSection() does.
std::map<std::string, std::string> ReportFiles(const ReportHead& head, const std::vector<PaperSection>& sections);

}  // namespace touchdown::experiments
