#include "scenarios/sweeper/run/failure_phase.h"

#include <gtest/gtest.h>

namespace touchdown::sweeper {
namespace {

using controller::Phase;

/// Log with one tick in each phase.
runner::FlightLog LogOf(const std::vector<Phase>& phases) {
  runner::FlightLog log;
  for (const Phase phase : phases) {
    log.ticks.emplace_back();
    log.ticks.back().control.phase = phase;
  }
  return log;
}

/// Frame with the whole ring in view.
runner::FrameRecord Frame(Phase phase, bool is_found) {
  runner::FrameRecord frame;
  frame.phase = phase;
  frame.status = is_found ? estimator::FrameStatus::kOk : estimator::FrameStatus::kNotFound;
  if (is_found) frame.pose.emplace();
  frame.ring_in_view = true;
  return frame;
}

TEST(FailurePhase, IsTheLastPhaseBeforeGivingUp) {
  const runner::Check outcome{.name = "outcome"};
  EXPECT_EQ(FailurePhase(outcome, LogOf({Phase::kHover, Phase::kLanding})), "landing");
  EXPECT_EQ(FailurePhase(outcome, LogOf({Phase::kLanding, Phase::kSearchClimb, Phase::kGaveUp, Phase::kGaveUp})),
            "search_climb");
  EXPECT_EQ(FailurePhase(outcome, {}), "");
}

TEST(FailurePhase, IsTouchdownForTouchdownMetrics) {
  EXPECT_EQ(FailurePhase({.name = "flight.touchdown_xy_error_m"}, LogOf({Phase::kLanding, Phase::kHover})),
            "touchdown");
}

TEST(FailurePhase, IsThePhaseWithMostVisionErrors) {
  runner::FlightLog log = LogOf({Phase::kTouchdown});
  for (int i = 0; i < 20; ++i) log.frames.push_back(Frame(Phase::kHover, true));
  for (int i = 0; i < 10; ++i) log.frames.push_back(Frame(Phase::kLanding, i % 2 == 0));
  log.frames.push_back(Frame(Phase::kTouchdown, true));
  EXPECT_EQ(FailurePhase({.name = "estimate.availability"}, log), "landing");
}

}  // namespace
}  // namespace touchdown::sweeper
