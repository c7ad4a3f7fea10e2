#include "scenarios/sweeper/analysis/sprt.h"

#include <cmath>

namespace touchdown::sweeper {

SequentialTest::SequentialTest(const StopWhen& stop)
    : log_ratio_of_pass_(std::log(stop.bad_pass_rate / stop.good_pass_rate)),
      // For a good rate of 1 the ratio is infinite, so that a single failure rejects it.
      log_ratio_of_failure_(std::log((1.0 - stop.bad_pass_rate) / (1.0 - stop.good_pass_rate))),
      good_below_(std::log(stop.bad_accepted / (1.0 - stop.good_refused))),
      bad_above_(std::log((1.0 - stop.bad_accepted) / stop.good_refused)) {}

SequentialTest::Decision SequentialTest::Add(bool passed) {
  if (decision_ != Decision::kOpen) return decision_;
  ++outcomes_;
  log_ratio_ += passed ? log_ratio_of_pass_ : log_ratio_of_failure_;
  if (log_ratio_ <= good_below_) decision_ = Decision::kGood;
  if (log_ratio_ >= bad_above_) decision_ = Decision::kBad;
  return decision_;
}

}  // namespace touchdown::sweeper
