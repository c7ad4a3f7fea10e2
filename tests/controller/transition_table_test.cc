#include "controller/transition_table.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace touchdown::controller {
namespace {

using enum Phase;
using Kind = ManeuverKind;

constexpr models::Tick kLimit = 1000;

PhaseLimits AllLimited() {
  PhaseLimits limits;
  limits.fill(kLimit);
  return limits;
}

/// Next phases from `phase` under `conditions`, before and after its time limit.
Phase Before(Phase phase, const Conditions& conditions) {
  return NextPhase(phase, conditions, kLimit - 1, AllLimited());
}
Phase After(Phase phase, const Conditions& conditions) { return NextPhase(phase, conditions, kLimit, AllLimited()); }

constexpr Conditions kNothing{};
constexpr Conditions kTakeoff{.task = Kind::kTakeoff};
constexpr Conditions kLand{.task = Kind::kLand};

constexpr Phase kAllPhases[] = {kStandby,      kBlindClimb, kRamp, kHover,       kLanding,
                                kBlindDescent, kTouchdown,  kHold, kSearchClimb, kGaveUp};

/// All combinations of conditions.
std::vector<Conditions> AllConditions() {
  std::vector<Conditions> all;
  const std::optional<Kind> tasks[] = {std::nullopt, Kind::kTakeoff, Kind::kHover, Kind::kLand};
  for (const auto& task : tasks) {
    for (int bits = 0; bits < 64; ++bits) {
      all.push_back({.task = task,
                     .pad_lost = (bits & 1) != 0,
                     .pad_found = (bits & 2) != 0,
                     .arrived = (bits & 4) != 0,
                     .ready_for_blind_descent = (bits & 8) != 0,
                     .low_enough = (bits & 16) != 0,
                     .high_enough = (bits & 32) != 0});
    }
  }
  return all;
}

TEST(TransitionTable, StandbyEndsAfterStandbyTimeIfTaskIsTakeoff) {
  EXPECT_EQ(Before(kStandby, kTakeoff), kStandby);
  EXPECT_EQ(After(kStandby, kTakeoff), kBlindClimb);
  EXPECT_EQ(After(kStandby, kLand), kStandby);
  EXPECT_EQ(After(kStandby, kNothing), kStandby);
}

TEST(TransitionTable, BlindClimbEndsInRampWhenPadIsFound) {
  EXPECT_EQ(Before(kBlindClimb, kTakeoff), kBlindClimb);
  EXPECT_EQ(Before(kBlindClimb, {.task = Kind::kTakeoff, .pad_found = true}), kRamp);
  EXPECT_EQ(After(kBlindClimb, {.task = Kind::kTakeoff, .pad_found = true, .high_enough = true}), kRamp);
}

TEST(TransitionTable, BlindClimbEndsInHoldAtHeightOrTimeLimit) {
  EXPECT_EQ(Before(kBlindClimb, {.pad_lost = true, .high_enough = true}), kHold);
  EXPECT_EQ(After(kBlindClimb, {.pad_lost = true}), kHold);
}

TEST(TransitionTable, RampEndsInHoverOnArrivalAndGivesUpAtTimeLimit) {
  EXPECT_EQ(Before(kRamp, kTakeoff), kRamp);
  EXPECT_EQ(Before(kRamp, {.arrived = true}), kHover);
  EXPECT_EQ(Before(kRamp, {.pad_lost = true, .arrived = true}), kHold);
  EXPECT_EQ(After(kRamp, kTakeoff), kGaveUp);
}

TEST(TransitionTable, HoverEndsWhenTaskIsLanding) {
  EXPECT_EQ(After(kHover, kNothing), kHover);
  EXPECT_EQ(After(kHover, {.task = Kind::kHover}), kHover);
  EXPECT_EQ(Before(kHover, kLand), kLanding);
  EXPECT_EQ(Before(kHover, {.task = Kind::kLand, .pad_lost = true}), kHold);
}

TEST(TransitionTable, LandingEndsInBlindDescentWhenReady) {
  EXPECT_EQ(Before(kLanding, kLand), kLanding);
  EXPECT_EQ(Before(kLanding, {.task = Kind::kLand, .low_enough = true}), kLanding);
  EXPECT_EQ(Before(kLanding, {.task = Kind::kLand, .ready_for_blind_descent = true}), kBlindDescent);
  EXPECT_EQ(Before(kLanding, {.task = Kind::kLand, .pad_lost = true, .ready_for_blind_descent = true}), kHold);
  EXPECT_EQ(After(kLanding, kLand), kGaveUp);
}

TEST(TransitionTable, BlindDescentEndsInTouchdownWithAndWithoutPad) {
  EXPECT_EQ(Before(kBlindDescent, {.task = Kind::kLand, .pad_lost = true}), kBlindDescent);
  EXPECT_EQ(Before(kBlindDescent, {.task = Kind::kLand, .pad_found = true}), kBlindDescent);
  EXPECT_EQ(Before(kBlindDescent, {.task = Kind::kLand, .low_enough = true}), kTouchdown);
  EXPECT_EQ(After(kBlindDescent, kLand), kTouchdown);
}

TEST(TransitionTable, HoldAndSearchClimbReturnToTaskWhenPadIsFound) {
  for (const Phase phase : {kHold, kSearchClimb}) {
    const auto found = [&](std::optional<Kind> task) {
      return After(phase, {.task = task, .pad_found = true, .high_enough = true});
    };
    EXPECT_EQ(found(Kind::kTakeoff), kRamp);
    EXPECT_EQ(found(Kind::kHover), kHover);
    EXPECT_EQ(found(Kind::kLand), kLanding);
    EXPECT_EQ(found(std::nullopt), kHover);
  }
}

TEST(TransitionTable, HoldEndsInSearchClimbWhichEndsInGivingUp) {
  EXPECT_EQ(Before(kHold, {.pad_lost = true, .high_enough = true}), kHold);
  EXPECT_EQ(After(kHold, {.pad_lost = true}), kSearchClimb);
  EXPECT_EQ(Before(kSearchClimb, {.pad_lost = true}), kSearchClimb);
  EXPECT_EQ(Before(kSearchClimb, {.pad_lost = true, .high_enough = true}), kGaveUp);
  EXPECT_EQ(After(kSearchClimb, {.pad_lost = true}), kGaveUp);
}

TEST(TransitionTable, TouchdownAndGaveUpAreFinal) {
  for (const Conditions& conditions : AllConditions()) {
    EXPECT_EQ(After(kTouchdown, conditions), kTouchdown);
    EXPECT_EQ(After(kGaveUp, conditions), kGaveUp);
  }
}

TEST(TransitionTable, HasRowForEveryReachableTransitionOnly) {
  std::set<std::pair<Phase, Phase>> happening, listed;
  for (const Transition& row : TransitionTable()) listed.insert({row.from, row.to});
  for (const Phase phase : kAllPhases) {
    for (const Conditions& conditions : AllConditions()) {
      for (const Phase next : {Before(phase, conditions), After(phase, conditions)}) {
        if (next != phase) happening.insert({phase, next});
      }
    }
  }
  EXPECT_EQ(happening, listed);
  EXPECT_EQ(listed.size(), 20U);
}

TEST(TransitionTable, ReachesEveryPhaseExceptInitialPhases) {
  std::set<Phase> reached{kStandby, kHold};
  for (const Transition& row : TransitionTable()) reached.insert(row.to);
  EXPECT_EQ(reached.size(), static_cast<std::size_t>(kPhaseCount));
}

TEST(TransitionTable, StopsMotorsOnlyAfterBlindDescent) {
  for (const Transition& row : TransitionTable()) {
    if (row.to == kTouchdown) {
      EXPECT_EQ(row.from, kBlindDescent);
    }
    EXPECT_NE(row.to, kStandby);
  }
}

TEST(TransitionTable, NeverTimesOutInPhaseWithoutLimit) {
  for (const Phase phase : kAllPhases) {
    EXPECT_EQ(NextPhase(phase, kNothing, models::Tick{1} << 40, PhaseLimits{}), phase) << Name(phase);
  }
}

TEST(TransitionTable, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const Phase phase : kAllPhases) names.insert(Name(phase));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kPhaseCount));
  EXPECT_EQ(Name(kStandby), "standby");
  EXPECT_EQ(Name(kBlindDescent), "blind_descent");
  EXPECT_EQ(Name(kGaveUp), "gave_up");
}

}  // namespace
}  // namespace touchdown::controller
