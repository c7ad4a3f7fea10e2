#pragma once

#include <vector>

#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Estimate of the value at which the pass rate falls, or rises, through a level: the posterior over a
/// logistic curve of the pass rate over the value (its place, its width, its direction, and a share of failures that
/// have nothing to do with the value), from a flat prior over the place within [min, max] and over the width's
/// logarithm. So adaptive searches for thresholds work (Kontsevich and Tyler 1999).
class PassBoundary {
 public:
  /// The level is the pass rate of interest, in (0, 1).
  PassBoundary(double min, double max, double level);

  /// So many flights at this value, independent of one another.
  void Take(double value, int passed, int failed);

  /// The value at which the pass rate is the level: the posterior's median, and where its middle 95 % lie. The interval
  /// reaches an end of [min, max] when the level may lie beyond it.
  util::Interval edge() const { return {Quantile(0.5), Quantile(0.025), Quantile(0.975)}; }
  /// The posterior's quantile of that value.
  double Quantile(double share) const;

 private:
  struct Curve {
    double edge;    ///< Where the rate is the level.
    double middle;  ///< Where the logistic is a half.
    double width;   ///< Positive where the rate falls.
    double lapse;   ///< Failures anywhere.
    double log_posterior;
  };

  double min_, max_;
  std::vector<Curve> curves_;
};

}  // namespace touchdown::sweeper
