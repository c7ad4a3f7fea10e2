#include "scenarios/sweeper/analysis/sweep_summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace touchdown::sweeper {
namespace {

/// Adds `flown` flights at a value, of which the first `passed` pass.
void Add(std::vector<PassTrial>& trials, double value, int passed, int flown) {
  for (int i = 0; i < flown; ++i) trials.push_back({value, static_cast<std::uint64_t>(i), i < passed});
}

/// Sweep of `flown` flights with a touchdown error of 1, 2, ... mm, of which the first `passed` pass.
SweepOutcome Landings(int passed, int flown, std::vector<SweepCriterion> criteria) {
  SweepOutcome sweep{.spec = {.criteria = std::move(criteria)}, .planned = static_cast<std::size_t>(flown)};
  for (int i = 0; i < flown; ++i) {
    sweep.results.push_back({.seed = static_cast<std::uint64_t>(i),
                             .row = {.verdict = i < passed ? runner::Verdict::kPass : runner::Verdict::kFail,
                                     .metrics = {{"flight.touchdown_xy_error_m", (i + 1) / 1000.0}}}});
  }
  return sweep;
}

SweepCheck Judged(int passed, int flown, const SweepCriterion& criterion) {
  return Summarize(Landings(passed, flown, {criterion})).criteria.at(0);
}

TEST(PassBoundaryOver, IsBetweenPassingAndFailingValues) {
  std::vector<PassTrial> trials;
  for (const double value : {0.0, 2.0, 4.0}) Add(trials, value, 10, 10);
  for (const double value : {6.0, 8.0, 10.0}) Add(trials, value, 0, 10);
  const util::Interval boundary = PassBoundaryOver(trials).value();
  EXPECT_GT(boundary.low, 3.5);
  EXPECT_NEAR(boundary.value, 5.0, 0.3);
  EXPECT_LT(boundary.high, 6.5);
  for (PassTrial& trial : trials) trial.passed = !trial.passed;
  EXPECT_NEAR(PassBoundaryOver(trials)->value, 5.0, 0.3) << "from failure to success";
}

TEST(PassBoundaryOver, IsNulloptWithoutAClearlyFailingValue) {
  std::vector<PassTrial> trials;
  for (const double value : {0.0, 1.0}) Add(trials, value, 10, 10);
  EXPECT_EQ(PassBoundaryOver(trials), std::nullopt);
  Add(trials, 2.0, 3, 10);
  EXPECT_EQ(PassBoundaryOver(trials), std::nullopt) << "3 of 10: 11 to 60 %";
  Add(trials, 3.0, 1, 10);
  EXPECT_NE(PassBoundaryOver(trials), std::nullopt) << "1 of 10: 2 to 40 %";
}

TEST(PassBoundaryOver, IsNulloptIfFlightsPassOnlyInTheMiddle) {
  std::vector<PassTrial> trials;
  Add(trials, 0.0, 0, 10);
  Add(trials, 1.0, 10, 10);
  Add(trials, 2.0, 0, 10);
  EXPECT_EQ(PassBoundaryOver(trials), std::nullopt);
}

TEST(SweepSummary, JudgesByTheValueOrByTheInterval) {
  // Wilson interval of 15 of 20: 0.5313 to 0.8881 (Newcombe 1998, method 3).
  const SweepCheck by_value = Judged(15, 20, {.metric = "pass_rate", .min = 0.7});
  EXPECT_TRUE(by_value.check.pass);
  EXPECT_EQ(by_value.check.limit, ">= 0.7");
  EXPECT_NEAR(by_value.interval->low, 0.5313, 1e-4);
  const SweepCheck by_interval = Judged(15, 20, {.metric = "pass_rate", .min = 0.7, .by = JudgedBy::kInterval});
  EXPECT_FALSE(by_interval.check.pass);
  EXPECT_EQ(by_interval.check.limit, ">= 0.7, by interval");
  EXPECT_TRUE(Judged(15, 20, {.metric = "pass_rate", .min = 0.53, .by = JudgedBy::kInterval}).check.pass);
  EXPECT_FALSE(Judged(15, 20, {.metric = "pass_rate", .max = 0.88, .by = JudgedBy::kInterval}).check.pass);
}

TEST(SweepSummary, JudgesAQuantileByOrderStatistics) {
  const std::string metric = "flight.touchdown_xy_error_m";
  // The 95 % interval of the median of 1 to 10 mm is from the second to the ninth value.
  const SweepCriterion median{.metric = metric, .quantile = 0.5, .max = 0.006};
  EXPECT_TRUE(Judged(10, 10, median).check.pass);
  SweepCriterion median_by_interval = median;
  median_by_interval.by = JudgedBy::kInterval;
  EXPECT_FALSE(Judged(10, 10, median_by_interval).check.pass);
  median_by_interval.max = 0.009;
  EXPECT_TRUE(Judged(10, 10, median_by_interval).check.pass);
  // Ten flights are too few for an upper bound of the 95 % quantile.
  const SweepCheck upper = Judged(10, 10, {.metric = metric, .quantile = 0.95, .max = 1e9, .by = JudgedBy::kInterval});
  EXPECT_FALSE(upper.check.pass);
  EXPECT_TRUE(std::isinf(upper.interval->high));
  EXPECT_EQ(upper.check.limit, "<= 1000000000, by interval, needs at least 72 seeds");
}

TEST(SweepSummary, DoesNotMeetACriterionOnAMetricThatNoFlightHas) {
  const SweepCheck check = Judged(3, 3, {.metric = "estimate.xy_rmse_m", .quantile = 0.5, .max = 1.0});
  EXPECT_FALSE(check.check.pass);
  EXPECT_EQ(check.interval, std::nullopt);
}

TEST(SweepSummary, JudgesTheDecisionOfTheSequentialTest) {
  SweepOutcome sweep = Landings(4, 4, {});
  // Each pass adds ln(0.5/0.9) to the log-likelihood ratio, so four of them reach ln(0.1/0.9).
  sweep.spec.stop_when = {.good_pass_rate = 0.9, .bad_pass_rate = 0.5, .good_refused = 0.1, .bad_accepted = 0.1};
  EXPECT_EQ(Summarize(sweep).criteria.at(0).check.text, "good");
  EXPECT_TRUE(Summarize(sweep).meets_criteria());
  sweep.results.pop_back();
  EXPECT_EQ(Summarize(sweep).criteria.at(0).check.text, "undecided") << "a flight is missing";
  sweep.planned = 3;
  EXPECT_EQ(Summarize(sweep).criteria.at(0).check.text, "undecided") << "there are no more seeds";
  EXPECT_FALSE(Summarize(sweep).meets_criteria());
  for (SweepResult& result : sweep.results) result.row.verdict = runner::Verdict::kFail;
  EXPECT_EQ(Summarize(sweep).criteria.at(0).check.text, "bad");
  EXPECT_FALSE(Summarize(sweep).meets_criteria());
}

TEST(SweepSummary, FindsTheBoundaryOfEachVariantOverEachListedNumber) {
  SweepOutcome sweep{
      .spec = {.axes = {{"camera.noise_sigma", {"0", "10"}}, {"start.yaw_deg", {}}}, .variants = {"sturdy", "weak"}}};
  for (const char* variant : {"sturdy", "weak"}) {
    for (const char* noise : {"0", "10"}) {
      const bool fails = variant == std::string("weak") && noise == std::string("10");
      for (std::uint64_t i = 0; i < 8; ++i) {
        sweep.results.push_back({.seed = i,
                                 .variant = variant,
                                 .values = {noise, "1.5"},
                                 .row = {.verdict = fails ? runner::Verdict::kFail : runner::Verdict::kPass}});
      }
    }
  }
  const SweepSummary summary = Summarize(sweep);
  ASSERT_EQ(summary.boundaries.size(), 1u);
  EXPECT_EQ(summary.boundaries[0].variant, "weak");
  EXPECT_EQ(summary.boundaries[0].key, "camera.noise_sigma");
  EXPECT_FALSE(summary.boundaries[0].may_lie_beyond);
}

TEST(SweepSummary, ReportsASearchedBoundaryThatMayBeBeyondTheRange) {
  SweepOutcome sweep{.spec = {.axes = {{"wind", {}}}, .search = SearchedBoundary{"wind", 0.0, 10.0, 0.6}}};
  for (std::uint64_t i = 0; i < 12; ++i) {
    sweep.results.push_back(
        {.seed = i, .values = {std::to_string(i % 11)}, .row = {.verdict = runner::Verdict::kPass}});
  }
  EXPECT_EQ(Summarize(sweep).boundaries.at(0).boundary, std::nullopt) << "all pass: no boundary";
  EXPECT_FALSE(Summarize(sweep).finds_boundary());
  sweep.results[5].row.verdict = runner::Verdict::kFail;
  const PassBoundaryOf boundary = Summarize(sweep).boundaries.at(0);
  EXPECT_EQ(boundary.pass_rate, 0.6);
  EXPECT_TRUE(boundary.boundary);
  EXPECT_TRUE(boundary.may_lie_beyond);
  for (SweepResult& result : sweep.results) result.row.verdict = runner::Verdict::kFail;
  EXPECT_FALSE(Summarize(sweep).finds_boundary());
}

TEST(SweepSummary, CountsTheFlightsOfASeedAsOneForIntervals) {
  SweepOutcome sweep{.spec = {.axes = {{"camera.noise_sigma", {"0", "10"}}},
                              .criteria = {{.metric = "flight.touchdown_xy_error_m", .quantile = 0.5, .max = 1.0}}}};
  for (const char* noise : {"0", "10"}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      sweep.results.push_back(
          {.seed = seed,
           .values = {noise},
           .row = {.verdict = runner::Verdict::kPass,
                   .metrics = {{"flight.touchdown_xy_error_m", static_cast<double>(seed + 1) / 1000.0}}}});
    }
  }
  const SweepSummary summary = Summarize(sweep);
  EXPECT_EQ(summary.all.flown, 20);
  EXPECT_EQ(summary.all.rate().low, util::WilsonInterval(10, 10).low);
  EXPECT_EQ(summary.by_value.at(0).count.rate().low, util::WilsonInterval(10, 10).low);
  EXPECT_DOUBLE_EQ(summary.criteria.at(0).interval->low, 0.002);
  EXPECT_DOUBLE_EQ(summary.criteria.at(0).interval->high, 0.009);
}

TEST(SweepSummary, CountsFailedProcesses) {
  SweepOutcome sweep = Landings(3, 5, {});
  for (SweepResult& result : sweep.results) result.row.process = ProcessEnd::kFlown;
  EXPECT_EQ(FailedProcesses(sweep.results), "");
  sweep.results[3].row.process = ProcessEnd::kHung;
  sweep.results[4].row.process = ProcessEnd::kOutOfMemory;
  EXPECT_EQ(FailedProcesses(sweep.results), "1 hung, 1 out of memory");
}

}  // namespace
}  // namespace touchdown::sweeper
