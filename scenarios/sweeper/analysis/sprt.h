#pragma once

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Wald's sequential probability ratio test of a pass rate (Wald 1945): given outcomes one after the other, it says as
/// soon as may be whether the rate is the good or the bad one of StopWhen, keeping the stated chances of error.
class SequentialTest {
 public:
  enum class Decision { kOpen, kGood, kBad };

  explicit SequentialTest(const StopWhen& stop);

  /// After a decision further outcomes change nothing.
  Decision Take(bool passed);
  Decision decision() const { return decision_; }
  /// Outcomes that it took to decide, or has taken.
  int taken() const { return taken_; }

 private:
  double log_ratio_of_pass_, log_ratio_of_failure_;  ///< Of the likelihoods, bad over good.
  double good_below_, bad_above_;
  double log_ratio_ = 0.0;
  Decision decision_ = Decision::kOpen;
  int taken_ = 0;
};

}  // namespace touchdown::sweeper
