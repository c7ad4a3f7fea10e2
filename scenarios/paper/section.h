#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/paper/figure.h"
#include "scenarios/paper/measurement.h"

namespace touchdown::scenarios {

/// A line of the report's summary: a figure of the paper beside ours. Smaller is better.
struct ComparedQuantity {
  std::string quantity = {};
  std::string unit = {};
  std::optional<double> published = {};  ///< nullopt where the paper gives words alone.
  std::optional<double> ours = {};       ///< nullopt where no flight gave one.
  std::string spread = {};               ///< "19.0 worst of 10 seeds", "95 %: 1.2 to 1.9".
  std::string why = {};                  ///< What makes the difference, in a sentence.

  bool IsKept() const { return !published || (ours && *ours <= *published); }
};

struct ReportTable {
  std::string name = {};  ///< Of its CSV file.
  std::string caption = {};
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

/// One experiment of the paper in the report.
struct ReportSection {
  std::string id = {};
  std::string title = {};                    ///< "Hand-held (Sec. VI-B.1, Fig. 6)".
  std::vector<std::string> paragraphs = {};  ///< HTML.
  std::vector<Figure> figures = {};
  std::vector<ReportPicture> pictures = {};
  std::vector<ReportTable> tables = {};
  std::vector<ComparedQuantity> compared = {};
};

/// What is to be measured, and how it is told.
struct Experiment {
  std::vector<Measurement> measurements = {};
  std::function<ReportSection(const Measured&)> report = {};
};

}  // namespace touchdown::scenarios
