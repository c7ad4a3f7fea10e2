#pragma once

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Wald's sequential probability ratio test of a pass rate (Wald 1945). It decides between the good and the bad rate of
/// StopWhen, with the error probabilities given there.
class SequentialTest {
 public:
  enum class Decision { kOpen, kGood, kBad };

  explicit SequentialTest(const StopWhen& stop);

  /// Adds an outcome and returns the decision so far. Outcomes after the decision are ignored.
  Decision Add(bool passed);
  Decision decision() const { return decision_; }
  /// Number of outcomes used: up to the decision, or so far.
  int outcomes() const { return outcomes_; }

 private:
  double log_ratio_of_pass_, log_ratio_of_failure_;  ///< Log-likelihood ratio of an outcome, bad rate over good.
  double good_below_, bad_above_;                    ///< Decision thresholds of the log-likelihood ratio.
  double log_ratio_ = 0.0;
  Decision decision_ = Decision::kOpen;
  int outcomes_ = 0;
};

}  // namespace touchdown::sweeper
