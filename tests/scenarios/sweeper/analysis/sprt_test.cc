#include "scenarios/sweeper/analysis/sprt.h"

#include <gtest/gtest.h>

#include "models/random_stream.h"

namespace touchdown::sweeper {
namespace {

using Decision = SequentialTest::Decision;

TEST(SequentialTest, AcceptsOnlyPassesAndRejectsOnlyFailures) {
  // Each pass adds ln(0.9/0.95), and the threshold is ln(0.05/0.95): 54.5 passes. Each failure adds ln 2: 4.2 failures.
  SequentialTest passes({.good_pass_rate = 0.95, .bad_pass_rate = 0.9});
  while (passes.Add(true) == Decision::kOpen) {
  }
  EXPECT_EQ(passes.decision(), Decision::kGood);
  EXPECT_EQ(passes.outcomes(), 55);
  SequentialTest failures({.good_pass_rate = 0.95, .bad_pass_rate = 0.9});
  while (failures.Add(false) == Decision::kOpen) {
  }
  EXPECT_EQ(failures.decision(), Decision::kBad);
  EXPECT_EQ(failures.outcomes(), 5);
}

TEST(SequentialTest, KeepsItsDecision) {
  SequentialTest test({.good_pass_rate = 1.0, .bad_pass_rate = 0.9});
  EXPECT_EQ(test.Add(false), Decision::kBad) << "a good rate of 1 allows no failure";
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(test.Add(true), Decision::kBad);
  EXPECT_EQ(test.outcomes(), 1);
}

/// Fraction of 2,000 sequences with this pass rate that end with this decision.
double FractionDecided(double pass_rate, Decision decision, const StopWhen& stop) {
  models::RandomStream random(7, "sequential_test");
  int count = 0;
  constexpr int kSequences = 2000;
  for (int i = 0; i < kSequences; ++i) {
    SequentialTest test(stop);
    while (test.Add(random.Bernoulli(pass_rate)) == Decision::kOpen) {
    }
    count += test.decision() == decision ? 1 : 0;
  }
  return static_cast<double>(count) / kSequences;
}

TEST(SequentialTest, KeepsItsErrorProbabilities) {
  const StopWhen stop{.good_pass_rate = 0.95, .bad_pass_rate = 0.85, .good_refused = 0.05, .bad_accepted = 0.1};
  // Wald's bounds are approximate: overshoot makes errors rarer. Three standard deviations of the fraction are 0.02.
  EXPECT_LT(FractionDecided(0.95, Decision::kBad, stop), 0.05 + 0.02);
  EXPECT_GT(FractionDecided(0.95, Decision::kBad, stop), 0.01);
  EXPECT_LT(FractionDecided(0.85, Decision::kGood, stop), 0.1 + 0.02);
  EXPECT_GT(FractionDecided(0.85, Decision::kGood, stop), 0.03);
}

}  // namespace
}  // namespace touchdown::sweeper
