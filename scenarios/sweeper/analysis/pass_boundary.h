#pragma once

#include <vector>

#include "scenarios/util/statistics.h"

namespace touchdown::sweeper {

/// Estimates the pass boundary: the value at which the pass rate crosses a level. The estimate is the posterior of a
/// logistic curve of the pass rate over the value. Its parameters are location, width, direction, and a fraction of
/// failures that does not depend on the value (lapse). The prior is flat over the location within [min, max] and over
/// the logarithm of the width. The method is that of adaptive threshold searches (Kontsevich and Tyler 1999).
class PassBoundary {
 public:
  /// `level` is the pass rate at the boundary, in (0, 1).
  PassBoundary(double min, double max, double level);

  /// Adds independent flights at a value: numbers of passed and failed ones.
  void Add(double value, int passed, int failed);

  /// Pass boundary: median and central 95 % interval of the posterior. The interval reaches a bound of [min, max] if
  /// the boundary may be beyond it.
  util::Interval boundary() const { return {Quantile(0.5), Quantile(0.025), Quantile(0.975)}; }
  /// Quantile of the posterior of the pass boundary.
  double Quantile(double probability) const;

 private:
  struct Curve {
    double location;  ///< Value at which the rate equals the level.
    double middle;    ///< Value at which the logistic function is 0.5.
    double width;     ///< Positive if the rate falls with the value.
    double lapse;     ///< Fraction of failures that does not depend on the value.
    double log_posterior;
  };

  double min_, max_;
  std::vector<Curve> curves_;
};

}  // namespace touchdown::sweeper
