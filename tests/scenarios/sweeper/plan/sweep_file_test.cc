#include "scenarios/sweeper/plan/sweep_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::sweeper {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using tests::ThrowsInputError;

class SweepFileTest : public testing::Test {
 protected:
  SweepFileTest() { folder_.Put("base.yaml", "script: [{do: hover, duration_s: 1}]\n"); }

  SweepFile Load(const std::string& text) { return LoadSweepFile(folder_.Put("s.yaml", "base: base.yaml\n" + text)); }
  auto Loading(const std::string& text) {
    return [this, text] { Load(text); };
  }

  const tests::TemporaryFolder folder_;
};

TEST_F(SweepFileTest, ReadsAllKindsOfParameters) {
  const SweepFile file = Load(R"(
description: All of them.
seeds: {from: 11, count: 4}
limits: {wall_s: 20}
parameters:
  camera.noise_sigma: [0, 3.5]
  pad.letter: ["H", 'x']
  start.position_m: [[0, 0, 1], [0.1, 0, 1]]
  camera.rate_hz: {range: {from: 0.1, to: 0.3, count: 3}}
  a: {uniform: {min: -1, max: 2}}
  b: {normal: {mean: 1, sigma: 0.5}}
  c: {latin_hypercube: {min: 0, max: 10}}
variants:
  - {name: plain}
  - {name: whole, set: {estimator.paper.contour_points: integer}}
criteria:
  - {metric: pass_rate, min: 0.9, by: interval}
  - {metric: flight.touchdown_speed_m_s, quantile: 0.95, max: 0.5}
)");
  EXPECT_EQ(file.name, "s");
  EXPECT_EQ(file.seeds.from, 11);
  EXPECT_EQ(file.seeds.count, 4);
  EXPECT_EQ(file.limits.wall_s, 20.0);
  ASSERT_EQ(file.parameters.size(), 7u);
  const auto listed = [&](std::size_t i) { return std::get<ListedValues>(file.parameters[i].values).yaml; };
  EXPECT_THAT(listed(0), ElementsAre("0", "3.5"));
  EXPECT_THAT(listed(1), ElementsAre("\"H\"", "\"x\""));
  EXPECT_THAT(listed(2), ElementsAre("[0, 0, 1]", "[0.1, 0, 1]"));
  EXPECT_THAT(listed(3), ElementsAre("0.1", "0.2", "0.3"));
  EXPECT_EQ(std::get<UniformValues>(file.parameters[4].values).max, 2.0);
  EXPECT_EQ(std::get<NormalValues>(file.parameters[5].values).sigma, 0.5);
  EXPECT_EQ(std::get<LatinHypercubeValues>(file.parameters[6].values).max, 10.0);
  ASSERT_EQ(file.variants.size(), 2u);
  EXPECT_EQ(file.variants[1].set.at(0).assignment, "estimator.paper.contour_points=integer");
  ASSERT_EQ(file.criteria.size(), 2u);
  EXPECT_EQ(file.criteria[0].by, JudgedBy::kInterval);
  EXPECT_EQ(file.criteria[1].by, JudgedBy::kValue);
}

TEST_F(SweepFileTest, AllowsStopWhenOnlyForASinglePassRate) {
  const std::string stop = "\nstop_when: {good_pass_rate: 0.9, bad_pass_rate: 0.8}";
  const SweepFile file = Load("parameters: {a: {uniform: {min: 0, max: 1}}, b: [3]}" + stop);
  EXPECT_EQ(file.stop_when.value().good_pass_rate, 0.9);
  EXPECT_THAT(Loading("parameters: {a: [1, 2]}" + stop),
              ThrowsInputError(HasSubstr("s.yaml:3: stop_when: requires a single pass rate")));
  EXPECT_THAT(Loading("variants: [{name: a}, {name: b}]" + stop),
              ThrowsInputError(HasSubstr("stop_when: requires a single pass rate")));
  EXPECT_THAT(Loading("criteria: [{metric: pass_rate, min: 0.9, by: interval}]" + stop),
              ThrowsInputError(HasSubstr("stop_when: is not allowed with a criterion on the interval")));
}

TEST_F(SweepFileTest, QuotesTextInOneLine) {
  const SweepFile file = Load("set:\n  camera:\n    model: wide, 1.yaml\nparameters:\n  description:\n    - a [b]");
  EXPECT_EQ(file.set.at(0).assignment, "camera={model: \"wide, 1.yaml\"}");
  EXPECT_THAT(std::get<ListedValues>(file.parameters.at(0).values).yaml, ElementsAre("\"a [b]\""));
}

TEST_F(SweepFileTest, AllowsSetForOtherKeysThanParameters) {
  EXPECT_EQ(Load("set: {camera: {rate_hz: 30}}\nparameters: {camera.noise_sigma: [1], camera.rate: [2]}").set.size(),
            1u);
}

TEST_F(SweepFileTest, DefaultsToOneUnnamedVariantAndOneSeed) {
  const SweepFile file = Load("");
  ASSERT_EQ(file.variants.size(), 1u);
  EXPECT_EQ(file.variants[0].name, "");
  EXPECT_EQ(file.seeds.count, 1);
  EXPECT_FALSE(file.stop_when);
}

TEST_F(SweepFileTest, ReportsErrorsWithFileLineAndKey) {
  const std::pair<const char*, const char*> cases[] = {
      {"parameters: {camera.noise_sigma: []}", "s.yaml:2: parameters.camera.noise_sigma: must have at least one value"},
      {"parameters: {a: [1, 2, 1]}", "s.yaml:2: parameters.a: 1 is listed twice"},
      {"parameters: {a: 3}", "s.yaml:2: parameters.a: must be a list of values, or one of range"},
      {"parameters: {a: {normal: {mean: 0, sigma: -1}}}", "sigma: must be at least 0, is -1"},
      {"parameters: {a: {uniform: {min: 1, max: 1}}}", "max: must be above min"},
      {"parameters: {a: {uniform: {min: 1}}}", "max: must be given"},
      {"parameters: {a: {range: {from: 0, to: 1, count: 1}}}", "count: must be from 2"},
      {"parameters: {a: {poisson: {mean: 1}}}", "or one of range, uniform, normal, latin_hypercube"},
      {"parameters: {seed: [1, 2]}", "parameters.seed: is not allowed; use the key seeds"},
      {"parameters: 3", "s.yaml:2: parameters: must have keys"},
      {"variants: [{name: a}]", "s.yaml:2: variants: must be a list of at least two variants"},
      {"variants: [{name: a}, {name: a}]", "variants.1.name: is listed twice"},
      {"variants: [{name: a}, {sett: {}}]", "variants.1.sett: is not allowed; allowed: name (text), set"},
      {"variants: [{name: a}, {set: {x: 1}}]", "variants.1.name: must be given"},
      {"seeds: {count: 0}", "s.yaml:2: seeds.count: must be from 1"},
      {"sedes: {count: 2}", "s.yaml:2: sedes: unknown key, did you mean seeds?"},
      {"parametrs: {a: [1]}", "s.yaml:2: parametrs: unknown key, did you mean parameters?"},
      {"set: {a: 1}\nparameters: {a: [1, 2]}", "s.yaml:3: parameters.a: a is already set"},
      {"parameters: {a.b: [1, 2]}\nset: {a: {c: 1, b: {d: 2}}}", "s.yaml:2: parameters.a.b: a.b.d is already set"},
      {"variants: [{name: a}, {name: b, set: {x: 4}}]\nparameters: {x: [1]}", "parameters.x: x is already set"},
      {"parameters: {p: [[0, 0]], p.1: [2]}", "s.yaml:2: parameters.p.1: p is already set"},
      {"parameters: {a: [1, 1.0]}", "s.yaml:2: parameters.a: 1 is listed twice"},
      {"criteria: [{metric: pass_rate, min: 95}]", "criteria.0: limits of pass_rate must be from 0 to 1"},
      {"stop_when: {good_pass_rate: 0.9}", "stop_when.bad_pass_rate: must be given"},
      {"criteria: [{metric: flight.speed, quantile: 0.5, max: 1}]", "unknown metric flight.speed"},
      {"criteria: [{metric: pass_rate}]", "min or max must be given"},
      {"criteria: [{metric: pass_rate, min: 1, quantile: 0.5}]", "quantile is not allowed for pass_rate"},
      {"criteria: [{metric: flight.sim_time_s, max: 1}]", "quantile must be given for a metric of flights"},
      {"criteria: [{metric: pass_rate, min: 1, by: luck}]", "criteria.0.by: must be one of value, interval"},
      {"stop_when: {good_pass_rate: 0.8, bad_pass_rate: 0.9}", "bad_pass_rate: must be below good_pass_rate"},
      {"set: {seed: 3}", "set.seed: is not allowed; use the key seeds"},
      {"variants: [{name: a, set: {seed: 3}}, {name: b}]", "variants.0.set.seed: is not allowed; use the key seeds"},
      {"parameters: {a: {range: {from: 1, to: 1, count: 3}}}", "to: must differ from `from`"},
      {"base: other.yaml", "s.yaml:2: base: duplicate key"},
  };
  for (const auto& [text, error] : cases) {
    EXPECT_THAT(Loading(text), ThrowsInputError(AllOf(HasSubstr(error), HasSubstr("s.yaml:")))) << text;
  }
}

TEST_F(SweepFileTest, RejectsAMissingScenario) {
  try {
    LoadSweepFile(folder_.Put("t.yaml", "seeds: {count: 2}\nbase: none.yaml\n"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("t.yaml:2: base: no such file: "));
  }
}

}  // namespace
}  // namespace touchdown::sweeper
