#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/rows_csv.h"
#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Loads the results of a sweep from its output directory, or from a CSV file of `touchdown sweep --csv`. Throws
/// InputError if `source` is neither or cannot be read.
StoredResults LoadResults(const std::string& source);

/// Results of one variant, without the variant name, so that two variants can be compared. Throws InputError if there
/// are none.
StoredResults OfVariant(const StoredResults& stored, const std::string& variant);

/// Difference of a quantity between two sweeps, B - A, over the flights that are in both.
struct PairedDifference {
  std::string name = {};  ///< "pass_rate" or the name of a metric.
  std::string unit = {};
  int pairs = 0;
  int seeds = 0;                           ///< Number of seeds of these pairs.
  double a = 0.0;                          ///< Mean of A.
  double b = 0.0;                          ///< Mean of B.
  util::Interval difference = {};          ///< Mean difference with its 95 % interval.
  double min_detectable_difference = 0.0;  ///< Smallest difference that these seeds detect with 80 % power.
  double margin = 0.0;                     ///< Largest acceptable worsening, at least 0.
  bool larger_is_better = false;
  bool is_worse = false;  ///< Significantly worse, and by more than the margin.
};

/// Largest acceptable worsening of a metric or of the pass rate.
struct Margin {
  std::string name = {};
  double margin = 0.0;
};

/// Result of a comparison of two sweeps, A and B.
struct Comparison {
  int only_a = 0;                                  ///< Number of flights that are only in A.
  int only_b = 0;                                  ///< Number of flights that are only in B.
  std::vector<PairedDifference> differences = {};  ///< The pass rate first, then the metrics.

  /// Whether a quantity is worse in B.
  bool is_worse() const;
};

/// Compares two sweeps over the pairs of flights with the same seed, variant and parameters. Pass rates are compared by
/// the interval of Bonett and Price for paired proportions (2012), metrics by Student's t on the differences, over the
/// pairs in which both flights have the metric. The pairs of a seed have the same floor, light and gusts, so their mean
/// counts as one pair. The pass rate and the metrics with a margin are judged: a quantity is worse if its whole
/// interval is on the worse side of zero and its difference exceeds the margin (0 for the pass rate, if not given).
/// Throws InputError if there is no pair, or for a margin of an unknown metric or of one that fewer than two seeds
/// have.
Comparison Compare(const StoredResults& a, const StoredResults& b, const std::vector<Margin>& margins);

}  // namespace touchdown::sweeper
