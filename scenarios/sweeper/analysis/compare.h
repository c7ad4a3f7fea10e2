#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/rows_csv.h"
#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// The results of a sweep, from its folder or from a CSV file that `touchdown sweep --csv` wrote. Throws InputError
/// when it is neither, or cannot be read.
StoredResults LoadResults(const std::string& source);

/// Results of one variant, as of a sweep without variants, for a comparison with another one. Throws
/// InputError when there are none.
StoredResults OfVariant(const StoredResults& stored, const std::string& variant);

/// Difference of a quantity between two sweeps, B - A, over the flights that both have.
struct PairedDifference {
  std::string name = {};  ///< "pass_rate", or a metric's.
  std::string unit = {};
  int pairs = 0;
  int seeds = 0;   ///< Of these pairs.
  double a = 0.0;  ///< Its mean.
  double b = 0.0;
  util::Interval difference = {};          ///< With 95 % confidence.
  double min_detectable_difference = 0.0;  ///< Smallest difference that these seeds detect with 80 % power.
  double margin = 0.0;                     ///< Largest acceptable worsening.
  bool larger_is_better = false;
  bool is_worse = false;  ///< Significantly worse, and by more than the margin.
};

/// Acceptable worsening of each metric.
struct Margin {
  std::string name = {};
  double margin = 0.0;
};

struct Comparison {
  int only_a = 0;  ///< Flights of A that B does not have.
  int only_b = 0;
  std::vector<PairedDifference> differences = {};  ///< The pass rate first.

  bool is_worse() const;
};

/// Pairs the flights of the same seed, variant and parameters. The pass rates are compared by Bonett and Price's
/// interval for paired proportions (2012), metrics by Student's t on the differences, over the pairs in which both have
/// the metric. The pairs of a seed, which have the same floor, light and gusts, count as one, by their mean. A quantity
/// counts as worse when its whole interval is on the worse side of zero and its difference exceeds the margin (default
/// 0). Throws InputError when they have no flight in common, or for a margin of an unknown metric, or of one that fewer
/// than two seeds have.
Comparison Compare(const StoredResults& a, const StoredResults& b, const std::vector<Margin>& margins);

}  // namespace touchdown::sweeper
