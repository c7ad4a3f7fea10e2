#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/experiments/measurement.h"
#include "scenarios/report/section.h"

namespace touchdown::experiments {

/// A row of the report's summary: the published value of a quantity and the measured one. Smaller is better.
struct ComparedQuantity {
  std::string quantity = {};
  std::string unit = {};
  std::optional<double> published = {};  ///< nullopt if the paper gives no number.
  std::optional<double> ours = {};       ///< Measured value; nullopt if no flight has one.
  std::string spread = {};               ///< For example "worst of 10 seeds 19.0" or "95 %: 1.2 to 1.9".
  std::string why = {};                  ///< Explanation of the difference, in one sentence.

  /// Whether the measured value is at most the published one. True if there is no published value, false if there is no
  /// measured one.
  bool MeetsPublished() const { return !published || (ours && *ours <= *published); }
};

/// Section of the report on one experiment of the paper. The title names the source, for example "Hand-held (Sec.
/// VI-B.1, Fig. 6)".
struct PaperSection : report::ReportSection {
  std::vector<ComparedQuantity> compared = {};
};

/// The measurements of an experiment, and the function that writes its section of the report from them.
struct Experiment {
  std::vector<Measurement> measurements = {};
  std::function<PaperSection(const Measured&)> report = {};
};

}  // namespace touchdown::experiments
