#include "scenarios/sweeper/analysis/sprt.h"

#include <gtest/gtest.h>

#include "models/random_stream.h"

namespace touchdown::sweeper {
namespace {

using Decision = SequentialTest::Decision;

TEST(SequentialTest, AcceptsARowOfPassesAndRefusesARowOfFailures) {
  // Each pass weighs ln(0.9/0.95), the bound is ln(0.05/0.95): 54.5 of them. Each failure weighs ln 2: 4.2 of them.
  SequentialTest passes({.good_pass_rate = 0.95, .bad_pass_rate = 0.9});
  while (passes.Take(true) == Decision::kOpen) {
  }
  EXPECT_EQ(passes.decision(), Decision::kGood);
  EXPECT_EQ(passes.taken(), 55);
  SequentialTest failures({.good_pass_rate = 0.95, .bad_pass_rate = 0.9});
  while (failures.Take(false) == Decision::kOpen) {
  }
  EXPECT_EQ(failures.decision(), Decision::kBad);
  EXPECT_EQ(failures.taken(), 5);
}

TEST(SequentialTest, StaysWithItsDecision) {
  SequentialTest test({.good_pass_rate = 1.0, .bad_pass_rate = 0.9});
  EXPECT_EQ(test.Take(false), Decision::kBad) << "a rate of 1 knows no failure";
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(test.Take(true), Decision::kBad);
  EXPECT_EQ(test.taken(), 1);
}

/// Of 2,000 sequences with this pass rate, the share that is decided so.
double ShareDecided(double pass_rate, Decision decision, const StopWhen& stop) {
  models::RandomStream random(7, "sequential_test");
  int count = 0;
  constexpr int kSequences = 2000;
  for (int i = 0; i < kSequences; ++i) {
    SequentialTest test(stop);
    while (test.Take(random.Bernoulli(pass_rate)) == Decision::kOpen) {
    }
    count += test.decision() == decision ? 1 : 0;
  }
  return static_cast<double>(count) / kSequences;
}

TEST(SequentialTest, KeepsItsProbabilitiesOfError) {
  const StopWhen stop{.good_pass_rate = 0.95, .bad_pass_rate = 0.85, .good_refused = 0.05, .bad_accepted = 0.1};
  // Wald's bounds hold about; overshoot makes the errors rarer. Three standard deviations of the share are 0.02.
  EXPECT_LT(ShareDecided(0.95, Decision::kBad, stop), 0.05 + 0.02);
  EXPECT_GT(ShareDecided(0.95, Decision::kBad, stop), 0.01);
  EXPECT_LT(ShareDecided(0.85, Decision::kGood, stop), 0.1 + 0.02);
  EXPECT_GT(ShareDecided(0.85, Decision::kGood, stop), 0.03);
}

}  // namespace
}  // namespace touchdown::sweeper
