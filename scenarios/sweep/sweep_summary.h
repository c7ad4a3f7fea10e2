#pragma once

#include <string>
#include <vector>

#include "scenarios/study/statistics.h"
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

/// All that is known of a sweep.
struct SweepOutcome {
  SweepTerms terms = {};
  std::vector<SweepResult> results = {};  ///< What is flown of the plan.
  std::size_t planned = 0;
  std::size_t stale = 0;  ///< Flights of another build.
};

/// Throws as SweepStore does.
SweepOutcome ReadOutcome(const SweepStore& store);

struct SweepSummary {
  PassCount all = {};
  std::vector<PassCountOf> by_value = {};  ///< Of keys with a few values each: those that are listed, not drawn.
  std::vector<Check> criteria = {};

  bool keeps_criteria() const;
};

/// A criterion on a metric that no flight has is not kept.
SweepSummary Summarize(const SweepOutcome& sweep);

/// Of the flights to which `belongs` applies.
template <typename Belongs>
PassCount CountWhere(const std::vector<SweepResult>& results, const Belongs& belongs) {
  PassCount count;
  for (const SweepResult& result : results) {
    if (!belongs(result)) continue;
    ++count.flown;
    count.passed += result.row.passed() ? 1 : 0;
  }
  return count;
}

/// Of the flights that have it.
std::vector<double> MetricValues(const std::vector<SweepResult>& results, const std::string& metric);

}  // namespace touchdown::scenarios
