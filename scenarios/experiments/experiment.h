#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/report/section.h"

namespace touchdown::experiments {

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

/// One experiment of the paper in the report. Its title is as "Hand-held (Sec. VI-B.1, Fig. 6)".
struct PaperSection : report::ReportSection {
  std::vector<ComparedQuantity> compared = {};
};

/// What is to be measured, and how it is told.
struct Experiment {
  std::vector<Measurement> measurements = {};
  std::function<PaperSection(const Measured&)> report = {};
};

}  // namespace touchdown::experiments
