#pragma once

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Wald's sequential probability ratio test of a pass rate (Wald 1945): it decides with few outcomes between the good
/// and the bad rate of StopWhen, with the error probabilities stated there.
class SequentialTest {
 public:
  enum class Decision { kOpen, kGood, kBad };

  explicit SequentialTest(const StopWhen& stop);

  /// Adds an outcome. Outcomes after the decision are ignored.
  Decision Take(bool passed);
  Decision decision() const { return decision_; }
  /// Number of outcomes up to the decision, or so far.
  int taken() const { return taken_; }

 private:
  double log_ratio_of_pass_, log_ratio_of_failure_;  ///< Log-likelihood ratio, bad over good.
  double good_below_, bad_above_;
  double log_ratio_ = 0.0;
  Decision decision_ = Decision::kOpen;
  int taken_ = 0;
};

}  // namespace touchdown::sweeper
