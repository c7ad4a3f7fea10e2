#include "scenarios/sweeper/analysis/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "models/error.h"
#include "models/random_stream.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

using testing::HasSubstr;

SweepResult Result(std::uint64_t seed, bool passed, std::optional<double> error_m = std::nullopt) {
  SweepResult result{.seed = seed, .values = {"3"}};
  result.row.id = "id" + std::to_string(seed);
  result.row.verdict = passed ? runner::Verdict::kPass : runner::Verdict::kFail;
  result.row.outcome = runner::Outcome::kLanded;
  if (error_m) result.row.metrics["flight.touchdown_xy_error_m"] = *error_m;
  return result;
}

StoredResults Stored(std::vector<SweepResult> results) {
  return {"a sweep", {"camera.noise_sigma"}, std::move(results)};
}

/// Two sweeps of 100 pairs: ten flights pass only in the first, and two only in the second.
std::pair<StoredResults, StoredResults> TenLostTwoGained() {
  StoredResults a = Stored({}), b = Stored({});
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    a.results.push_back(Result(seed, seed >= 2));
    b.results.push_back(Result(seed, seed < 90));
  }
  return {a, b};
}

const PairedDifference& Of(const Comparison& comparison, const std::string& name) {
  for (const PairedDifference& difference : comparison.differences) {
    if (difference.name == name) return difference;
  }
  throw std::out_of_range(name);
}

TEST(Compare, UsesTheIntervalOfBonettAndPriceForPassRates) {
  const auto [a, b] = TenLostTwoGained();
  const PairedDifference d = Of(Compare(a, b, {}), "pass_rate");
  EXPECT_EQ(d.pairs, 100);
  EXPECT_DOUBLE_EQ(d.a, 0.98);
  EXPECT_DOUBLE_EQ(d.b, 0.90);
  EXPECT_NEAR(d.difference.value, -0.08, 1e-12);
  // (3 - 11) / 102 -+ 1.96 sqrt((14/102 - (8/102)^2) / 102), calculated by hand.
  EXPECT_NEAR(d.difference.low, -0.14870, 2e-5);
  EXPECT_NEAR(d.difference.high, -0.00816, 2e-5);
}

TEST(Compare, IsWorseIfSignificantAndBeyondTheMargin) {
  const auto [a, b] = TenLostTwoGained();
  EXPECT_TRUE(Compare(a, b, {}).is_worse());
  EXPECT_TRUE(Compare(a, b, {{"pass_rate", 0.05}}).is_worse());
  EXPECT_FALSE(Compare(a, b, {{"pass_rate", 0.1}}).is_worse()) << "worse, but within the margin";
  EXPECT_FALSE(Compare(b, a, {}).is_worse()) << "better";
  EXPECT_FALSE(Compare(a, a, {}).is_worse());
  StoredResults few_a = Stored({Result(1, true), Result(2, true), Result(3, true)}), few_b = few_a;
  few_b.results[0].row.verdict = runner::Verdict::kFail;
  EXPECT_FALSE(Compare(few_a, few_b, {}).is_worse()) << "one of three is not significant";
}

TEST(Compare, DetectsASmallChangeOfAMetricOnTheSameSeeds) {
  StoredResults a = Stored({}), b = Stored({});
  models::RandomStream random(3, "compare_test");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const double error_m = 0.02 + 0.01 * random.Normal();  // The seeds differ far more than the two sweeps.
    a.results.push_back(Result(seed, true, error_m));
    b.results.push_back(Result(seed, true, error_m + 0.001 + 0.001 * random.Normal()));
  }
  const PairedDifference d = Of(Compare(a, b, {}), "flight.touchdown_xy_error_m");
  EXPECT_NEAR(d.difference.value, 0.001, 0.0005);
  EXPECT_GT(d.difference.low, 0.0);
  // (t(0.975) + t(0.8)) s / sqrt(n), with s about 1 mm: 2.01 + 0.85.
  EXPECT_NEAR(d.min_detectable_difference, 2.86 * 0.001 / std::sqrt(50.0), 0.0001);
  EXPECT_FALSE(d.is_worse) << "metrics without a margin are not judged";
  EXPECT_TRUE(Compare(a, b, {{"flight.touchdown_xy_error_m", 0.0}}).is_worse());
  EXPECT_FALSE(Compare(a, b, {{"flight.touchdown_xy_error_m", 0.005}}).is_worse());
  EXPECT_FALSE(Compare(b, a, {{"flight.touchdown_xy_error_m", 0.0}}).is_worse());
}

TEST(Compare, PairsFlightsBySeedVariantAndParametersOnly) {
  StoredResults a = Stored({Result(1, true), Result(2, true)}), b = Stored({Result(2, false), Result(3, true)});
  b.results[0].row.id = "of another build";
  const Comparison comparison = Compare(a, b, {});
  EXPECT_EQ(Of(comparison, "pass_rate").pairs, 1);
  EXPECT_EQ(comparison.only_a, 1);
  EXPECT_EQ(comparison.only_b, 1);
  b.results[0].variant = "other";
  EXPECT_THROW(Compare(a, b, {}), InputError);
  b = Stored({Result(1, true)});
  b.results[0].values = {"4"};
  EXPECT_THROW(Compare(a, b, {}), InputError);
  EXPECT_THROW(Compare(a, a, {{"flight.speed", 1.0}}), InputError);
  EXPECT_THROW(Compare(a, a, {{"pass_rate", 2.0}}), InputError);
}

TEST(Compare, DetectsAChangeOfThePassRateWithEightyPercentPower) {
  StoredResults a = Stored({});
  constexpr int kPairs = 100;
  for (std::uint64_t seed = 0; seed < kPairs; ++seed) a.results.push_back(Result(seed, true));
  const double change = Of(Compare(a, a, {}), "pass_rate").min_detectable_difference;
  EXPECT_NEAR(change, 0.078, 0.001) << "six of a hundred must fail for significance";
  models::RandomStream random(1, "min_detectable_difference");
  constexpr int kTrials = 400;
  int detected = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    StoredResults b = a;
    for (SweepResult& result : b.results)
      result.row.verdict = random.Uniform() < change ? runner::Verdict::kFail : runner::Verdict::kPass;
    detected += Compare(a, b, {}).is_worse() ? 1 : 0;
  }
  EXPECT_NEAR(detected / static_cast<double>(kTrials), 0.8, 0.06);
  a.results.resize(3);
  EXPECT_EQ(Of(Compare(a, a, {}), "pass_rate").min_detectable_difference, 1.0) << "three pairs cannot detect a change";
}

TEST(Compare, CountsThePairsOfASeedAsOne) {
  // The same ten seeds at one value and at three values. The other two values add pairs, but no evidence.
  StoredResults a = Stored({}), b = Stored({}), a_grid = Stored({}), b_grid = Stored({});
  models::RandomStream random(5, "compare_test");
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const double error_m = 0.02 + 0.001 * random.Normal(), change_m = 0.001 * random.Normal();
    a.results.push_back(Result(seed, true, error_m));
    b.results.push_back(Result(seed, seed >= 3, error_m + change_m));
    for (const char* value : {"3", "4", "5"}) {
      for (const auto& [from, to] : {std::pair(&a, &a_grid), {&b, &b_grid}}) {
        to->results.push_back(from->results.back());
        to->results.back().values = {value};
      }
    }
  }
  const Comparison once = Compare(a, b, {}), thrice = Compare(a_grid, b_grid, {});
  for (const char* name : {"pass_rate", "flight.touchdown_xy_error_m"}) {
    const PairedDifference one = Of(once, name), three = Of(thrice, name);
    EXPECT_EQ(three.pairs, 30);
    EXPECT_EQ(three.seeds, 10);
    EXPECT_NEAR(three.difference.value, one.difference.value, 1e-12);
    EXPECT_NEAR(three.difference.low, one.difference.low, 1e-12);
    EXPECT_NEAR(three.difference.high, one.difference.high, 1e-12);
    EXPECT_NEAR(three.min_detectable_difference, one.min_detectable_difference, 1e-12);
  }
}

TEST(Compare, RejectsAMarginOfAMetricWithoutEnoughPairs) {
  const StoredResults a = Stored({Result(1, true), Result(2, true, 0.01)});
  EXPECT_THROW(Compare(a, a, {{"flight.touchdown_xy_error_m", 0.005}}), InputError);
}

TEST(Compare, ComparesTheVariantsOfASweep) {
  StoredResults both = Stored({Result(1, true), Result(2, true), Result(1, false), Result(2, true)});
  for (std::size_t i = 0; i < 4; ++i) both.results[i].variant = i < 2 ? "old" : "new";
  const Comparison comparison = Compare(OfVariant(both, "old"), OfVariant(both, "new"), {});
  EXPECT_EQ(Of(comparison, "pass_rate").pairs, 2);
  EXPECT_DOUBLE_EQ(Of(comparison, "pass_rate").difference.value, -0.5);
  EXPECT_THROW(OfVariant(both, "newest"), InputError);
}

TEST(Compare, ReadsTheRowsOfAnEarlierSweepFromCsv) {
  const tests::TemporaryFolder folder;
  StoredResults a = Stored({Result(1, true, 0.1 + 0.2), Result(2, false)});
  a.results[1].values = {"[1, \"two\"]"};
  const auto file = folder.Put("rows.csv", RowsCsv(a.keys, a.results));
  const StoredResults read = LoadResults(file.string());
  EXPECT_EQ(read.keys, a.keys);
  ASSERT_EQ(read.results.size(), 2u);
  EXPECT_EQ(read.results[0].row.metrics.at("flight.touchdown_xy_error_m"), 0.1 + 0.2);
  EXPECT_EQ(read.results[1].values, a.results[1].values);
  EXPECT_EQ(read.results[1].row.verdict, runner::Verdict::kFail);
  EXPECT_EQ(Of(Compare(a, read, {}), "pass_rate").difference.value, 0.0);
  const auto older = folder.Put("older.csv",
                                "id,variant,seed,verdict,outcome,log_sha256\n"
                                "a,,1,error,crashed,\nb,,2,fail,crashed,h\nc,,3,error,error,\n");
  const StoredResults without_process = LoadResults(older.string());
  EXPECT_EQ(without_process.results[0].row.process, ProcessEnd::kCrashed);
  EXPECT_EQ(without_process.results[0].row.outcome, runner::Outcome::kError);
  EXPECT_EQ(without_process.results[1].row.process, ProcessEnd::kFlown);
  EXPECT_EQ(without_process.results[1].row.outcome, runner::Outcome::kCrashed);
  EXPECT_EQ(without_process.results[2].row.process, ProcessEnd::kFlown);
  for (const auto& [text, error] :
       {std::pair("x,y\n1,2\n", "bad.csv:1: not the header of sweep rows"),
        {"id,variant,seed,verdict,outcome,log_sha256\na,,1,pass\n", "bad.csv:2: not a row"},
        {"id,variant,seed,verdict,outcome,log_sha256\na,,x,pass,landed,h\n", "bad.csv:2: not a row"},
        {"id,variant,seed,verdict,outcome,log_sha256\na,,-1,pass,landed,h\n", "bad.csv:2: not a row"},
        {"id,variant,seed,process,verdict,outcome,log_sha256\na,,1,flow,pass,landed,h\n", "bad.csv:2: not a row"},
        {"id,variant,seed,process,verdict,outcome,log_sha256\na,,1,flown,pass,fine,h\n", "bad.csv:2: not a row"},
        {"id,variant,seed,verdict,outcome,log_sha256\na,,1,maybe,landed,h\n", "bad.csv:2: not a row"},
        {"id,variant,seed,verdict,outcome,flight.sim_time_s,log_sha256\na,,1,pass,landed,nan,h\n", "bad.csv:2: not a"},
        {"id,variant,seed,verdict,outcome,flight.sim_time_s,log_sha256\na,,1,pass,landed,0.1s,h\n",
         "bad.csv:2: not"}}) {
    try {
      LoadResults(folder.Put("bad.csv", text).string());
      ADD_FAILURE() << text;
    } catch (const InputError& thrown) {
      EXPECT_THAT(thrown.what(), HasSubstr(error));
    }
  }
}

}  // namespace
}  // namespace touchdown::sweeper
