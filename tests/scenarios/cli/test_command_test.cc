// `touchdown test` and `touchdown compare`, run as programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program_fixture.h"

namespace touchdown::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using tests::ProgramRun;

class TestCommand : public tests::ProgramFixture {
 protected:
  static inline const std::string kShort =
      "start: {airborne: true, position_m: [0, 0, 0.4]}\nscript: [{do: hover, position_m: [0, 0, 0.4], duration_s: "
      "0.1}]\n";
};

TEST_F(TestCommand, PassesWhenEveryScenarioPasses) {
  folder_.Put("flights/a.yaml", kShort);
  folder_.Put("flights/b.yaml", kShort);
  folder_.Put("flights/lens.txt", "no scenario");
  const ProgramRun run = Run({"test", "flights", "--junit", "j.xml"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("pass  a "), HasSubstr("pass  b "), HasSubstr("2 of 2 flights passed\n")));
  EXPECT_THAT(folder_.Content("j.xml"), AllOf(HasSubstr("\"a.seed1\""), HasSubstr("failures=\"0\"")));
}

TEST_F(TestCommand, PrintsTheFailedCriterionAndHowToReproduceIt) {
  folder_.Put("flights/a.yaml", kShort);
  folder_.Put("flights/b.yaml", kShort + "criteria: [{metric: flight.sim_time_s, max: 0.1}]\n");
  const ProgramRun run = Run({"test", "flights", "--junit", "j.xml", "--jobs", "1"});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("FAIL  b "), HasSubstr("flight.sim_time_s is 0.215 s, must be <= 0.1\n"),
                             HasSubstr("touchdown fly flights/b.yaml\n"), HasSubstr("1 of 2 flights passed\n")));
  EXPECT_THAT(folder_.Content("j.xml"), AllOf(HasSubstr("failures=\"1\""), HasSubstr("must be &lt;= 0.1")));
}

TEST_F(TestCommand, FliesNothingWhenAScenarioIsInvalid) {
  folder_.Put("flights/a.yaml", kShort);
  folder_.Put("flights/b.yaml", kShort + "sed: 1\n");
  EXPECT_THAT(ErrorOf({"test", "flights"}), HasSubstr("b.yaml:3: sed: unknown key"));
  EXPECT_THAT(ErrorOf({"test", "none"}), HasSubstr("none: "));
  folder_.Put("empty/readme.txt", "");
  EXPECT_THAT(ErrorOf({"test", "empty"}), HasSubstr("empty: no scenarios in this folder"));
}

TEST_F(TestCommand, ComparisonWithABaselineFailsWhenFlightsGetWorse) {
  folder_.Put("short.yaml", kShort + "criteria: [{metric: estimate.availability, min: 0.5}]\n");
  folder_.Put("sweep.yaml", "base: short.yaml\nseeds: {count: 8}\n");
  ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", "before", "--csv", "baseline.csv", "--quiet"}).status, 0);
  // The change: the pad is missing.
  folder_.Put("short.yaml", kShort + "scene: {pad: false}\ncriteria: [{metric: estimate.availability, min: 0.5}]\n");
  ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", "after", "--quiet"}).status, 0);
  const ProgramRun run = Run({"compare", "baseline.csv", "after"});
  EXPECT_EQ(run.status, 1) << run.out << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("8 pairs of 8 seeds; 0 flights only in baseline.csv"), HasSubstr("worse: pass_rate")));
  EXPECT_EQ(Run({"compare", "baseline.csv", "before", "--margin", "pass_rate=0.1"}).status, 0);
  EXPECT_THAT(Run({"compare", "baseline.csv", "before", "--margin", "pass_rate=0.1"}).out, HasSubstr("fly more seeds"));
  std::string csv = folder_.Content("baseline.csv");
  csv.resize(csv.rfind('\n', csv.size() - 2) + 1);
  folder_.Put("part.csv", csv);
  EXPECT_THAT(Run({"compare", "baseline.csv", "part.csv"}).err,
              HasSubstr("part.csv lacks 1 flights of baseline.csv, which are not compared"));
  EXPECT_THAT(ErrorOf({"compare", "baseline.csv"}), HasSubstr("give two sweeps, or one sweep and --variants"));
  EXPECT_THAT(ErrorOf({"compare", "before", "--variants", "old", "new"}),
              HasSubstr("contains no flights of variant old"));
  EXPECT_THAT(ErrorOf({"compare", "baseline.csv", "none.csv"}), HasSubstr("none.csv: cannot be read"));
  EXPECT_THAT(ErrorOf({"compare", "baseline.csv", "before", "--margin", "pass_rate"}), HasSubstr("NAME=NUMBER"));
}

}  // namespace
}  // namespace touchdown::cli
