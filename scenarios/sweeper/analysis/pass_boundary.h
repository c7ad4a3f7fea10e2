#pragma once

#include <vector>

#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Estimate of the value at which the pass rate falls, or rises, through a level: the posterior over a
/// logistic curve of the pass rate over the value (location, width, direction, and a fraction of failures that do not
/// depend on the value), from a flat prior over the location within [min, max] and over the logarithm of the width. The
/// method is that of adaptive threshold searches (Kontsevich and Tyler 1999).
class PassBoundary {
 public:
  /// The level is the pass rate of interest, in (0, 1).
  PassBoundary(double min, double max, double level);

  /// Adds independent flights at a value.
  void Take(double value, int passed, int failed);

  /// Value at which the pass rate equals the level: median and central 95 % of the posterior. The interval reaches an
  /// end of [min, max] when the boundary may lie beyond it.
  util::Interval edge() const { return {Quantile(0.5), Quantile(0.025), Quantile(0.975)}; }
  /// Quantile of the posterior of that value.
  double Quantile(double share) const;

 private:
  struct Curve {
    double edge;    ///< Value at which the rate equals the level.
    double middle;  ///< Value at which the logistic function is 0.5.
    double width;   ///< Positive for a rate that falls.
    double lapse;   ///< Fraction of failures independent of the value.
    double log_posterior;
  };

  double min_, max_;
  std::vector<Curve> curves_;
};

}  // namespace touchdown::sweeper
