#pragma once

#include <string>
#include <vector>

#include "scenarios/study/statistics.h"
#include "scenarios/sweep/sweep_file.h"
#include "scenarios/sweep/sweep_store.h"

namespace touchdown::scenarios {

/// How many of some flights passed, with the Wilson interval of the share.
struct PassCount {
  int flown = 0;
  int passed = 0;

  Interval rate() const { return ShareInterval(passed, flown); }  ///< Of at least one flight.
};

/// The flights that share a value of a parameter, or a variant.
struct PassCountOf {
  std::string key = {};    ///< "variant" for the variants.
  std::string value = {};  ///< As YAML.
  PassCount count = {};
};

struct SweepSummary {
  int planned = 0;
  PassCount all = {};
  std::vector<PassCountOf> by_value = {};  ///< Of keys with a few values each: those that are listed, not drawn.
  std::vector<Check> criteria = {};

  bool keeps_criteria() const;
};

/// `results` are what is flown of `planned` flights. A criterion on a metric that no flight has is not kept.
SweepSummary Summarize(const SweepFile& file, const std::vector<SweepResult>& results, std::size_t planned);

/// Of the flights that have it.
std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric);

}  // namespace touchdown::scenarios
