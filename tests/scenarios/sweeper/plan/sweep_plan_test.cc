#include "scenarios/sweeper/plan/sweep_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "models/error.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SweepPlanTest : public testing::Test {
 protected:
  SweepPlanTest() {
    folder_.Put("base.yaml",
                "script: [{do: hover, duration_s: 1}]\nstart: {airborne: true}\ncamera: {model: lens.yaml}\n");
    folder_.Put("lens.yaml", "k1: -0.1\n");
  }

  SweepPlan Plan(const std::string& text, const std::string& program = "program") {
    return PlanSweep(LoadSweepFile(folder_.Put("s.yaml", "base: base.yaml\n" + text)), program);
  }
  static std::vector<std::string> Ids(const SweepPlan& plan) {
    std::vector<std::string> ids;
    for (const PlannedFlight& flight : plan.flights) ids.push_back(flight.id);
    return ids;
  }
  /// Values of the first parameter.
  static std::vector<double> Values(const SweepPlan& plan) {
    std::vector<double> values;
    for (const PlannedFlight& flight : plan.flights) values.push_back(std::stod(flight.values.at(0)));
    return values;
  }

  const tests::TemporaryFolder folder_;
};

TEST_F(SweepPlanTest, SpacesSubnormalNumbersEvenly) {
  const SweepPlan plan = Plan("parameters: {world.wind_m_s.0: {range: {from: 0, to: 1e-310, count: 3}}}\n");
  std::vector<std::string> values;
  for (const PlannedFlight& flight : plan.flights) values.push_back(flight.values.at(0));
  EXPECT_THAT(values, ElementsAre("0", "5e-311", "1e-310"));
}

TEST_F(SweepPlanTest, CrossesSeedsValuesAndVariants) {
  const SweepPlan plan = Plan(R"(
seeds: {from: 5, count: 2}
parameters:
  camera.noise_sigma: [0, 3]
  camera.exposure_ms: {range: {from: 2, to: 4, count: 3}}
variants: [{name: a}, {name: b, set: {estimator.paper.contour_points: integer}}]
)");
  ASSERT_EQ(plan.flights.size(), 24u);
  EXPECT_THAT(plan.keys, ElementsAre("camera.noise_sigma", "camera.exposure_ms"));
  const std::vector<std::string> ids = Ids(plan);
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 24u);
  EXPECT_EQ(plan.flights[0].seed, 5u);
  EXPECT_EQ(plan.flights[11].seed, 5u);
  EXPECT_EQ(plan.flights[12].seed, 6u);
  EXPECT_EQ(plan.flights[1].variant, "b");
  EXPECT_THAT(plan.flights[2].values, ElementsAre("0", "3"));
  EXPECT_THAT(plan.flights[11].values, ElementsAre("3", "4"));
  const runner::Scenario last = runner::ParseScenario(plan.flights[23].scenario_yaml, "s", {});
  EXPECT_EQ(last.seed, 6u);
  EXPECT_EQ(last.camera.noise_sigma, 3.0);
  EXPECT_EQ(last.camera.exposure_ms, 4.0);
  EXPECT_EQ(last.estimator.paper.contour_points, estimator::pad::ContourPoints::kInteger);
  for (std::size_t i = 0; i < plan.flights.size(); ++i)
    EXPECT_EQ(plan.flights[i].position, static_cast<std::int64_t>(i));
}

TEST_F(SweepPlanTest, FlightIdDependsOnAllInputs) {
  const std::string id = Ids(Plan("")).at(0);
  EXPECT_EQ(id.size(), 16u);
  EXPECT_EQ(Ids(Plan("name: another\n")).at(0), id);
  EXPECT_EQ(Ids(Plan("parameters: {camera.noise_sigma: [3]}\n")).at(0), id) << "the value is the default";
  EXPECT_NE(Ids(Plan("parameters: {camera.noise_sigma: [4]}\n")).at(0), id);
  EXPECT_NE(Ids(Plan("seeds: {from: 2}\n")).at(0), id);
  EXPECT_NE(Ids(Plan("", "another build")).at(0), id);
  folder_.Put("lens.yaml", "k1: -0.11\n");
  EXPECT_NE(Ids(Plan("")).at(0), id) << "a referenced file changed";
}

TEST_F(SweepPlanTest, KeepsFlightsWhenSeedsAreAdded) {
  const std::string parameters =
      "parameters: {camera.noise_sigma: {uniform: {min: 0, max: 5}}, camera.exposure_ms: {normal: {mean: 4, sigma: "
      "0.1}}}\n";
  const auto few = Ids(Plan("seeds: {count: 3}\n" + parameters)), many = Ids(Plan("seeds: {count: 5}\n" + parameters));
  EXPECT_THAT(std::vector<std::string>(many.begin(), many.begin() + 3), testing::ElementsAreArray(few));
  // A second parameter does not shift the first one's draws.
  EXPECT_EQ(Values(Plan("seeds: {count: 3}\n" + parameters)),
            Values(Plan("seeds: {count: 3}\nparameters: {camera.noise_sigma: {uniform: {min: 0, max: 5}}}\n")));
}

TEST_F(SweepPlanTest, DrawsTheSameValuesForAllVariantsOfASeed) {
  const SweepPlan plan = Plan(
      "seeds: {count: 4}\nparameters: {camera.noise_sigma: {uniform: {min: 0, max: 5}}}\n"
      "variants: [{name: a}, {name: b, set: {camera.exposure_ms: 8}}]\n");
  for (std::size_t i = 0; i < plan.flights.size(); i += 2) {
    EXPECT_EQ(plan.flights[i].values, plan.flights[i + 1].values);
  }
}

TEST_F(SweepPlanTest, DrawsFromTheGivenDistributions) {
  const std::vector<double> uniform =
      Values(Plan("seeds: {count: 400}\nparameters: {camera.noise_sigma: {uniform: {min: 1, max: 3}}}\n"));
  const auto [least, most] = std::minmax_element(uniform.begin(), uniform.end());
  EXPECT_GE(*least, 1.0);
  EXPECT_LT(*least, 1.05);
  EXPECT_LE(*most, 3.0);
  EXPECT_GT(*most, 2.95);
  const std::vector<double> normal =
      Values(Plan("seeds: {count: 400}\nparameters: {start.position_m.0: {normal: {mean: 0.5, sigma: 0.2}}}\n"));
  double sum = 0.0, squares = 0.0;
  for (const double value : normal) {
    sum += value;
    squares += (value - 0.5) * (value - 0.5);
  }
  EXPECT_NEAR(sum / 400.0, 0.5, 4.0 * 0.2 / 20.0);
  EXPECT_NEAR(std::sqrt(squares / 400.0), 0.2, 0.03);
}

TEST_F(SweepPlanTest, DrawsOneValuePerLatinHypercubeInterval) {
  const SweepPlan plan = Plan(
      "seeds: {count: 50}\nparameters: {camera.noise_sigma: {latin_hypercube: {min: 0, max: 5}}, "
      "camera.exposure_ms: {latin_hypercube: {min: 0, max: 5}}}\n");
  for (const std::size_t key : {0u, 1u}) {
    std::set<int> parts;
    for (const PlannedFlight& flight : plan.flights)
      parts.insert(static_cast<int>(std::stod(flight.values[key]) * 10.0));
    EXPECT_EQ(parts.size(), 50u);
  }
  int same = 0;
  for (const PlannedFlight& flight : plan.flights) {
    same +=
        static_cast<int>(std::stod(flight.values[0]) * 10.0) == static_cast<int>(std::stod(flight.values[1]) * 10.0);
  }
  EXPECT_LT(same, 10) << "each key has its own order";
}

TEST_F(SweepPlanTest, ReportsInvalidScenarioKeysWithFileAndLine) {
  for (const auto& [text, error] :
       {std::pair("parameters:\n  camera.noise_sigm: [1]\n",
                  "s.yaml:3: camera.noise_sigm: unknown key, did you mean noise_sigma?"),
        {"parameters:\n  camera.noise_sigma: [-1]\n", "s.yaml:3: camera.noise_sigma: must be"},
        {"parameters:\n  camera.noise_sigma: {uniform: {min: -9, max: -8}}\n",
         "s.yaml:3 (drawn for seed 1): camera.noise_sigma: must be"},
        {"variants:\n  - {name: a}\n  - {name: b, set: {x: 1}}\n", "s.yaml:4: x: unknown key"}}) {
    try {
      Plan(text);
      ADD_FAILURE() << text;
    } catch (const InputError& thrown) {
      EXPECT_THAT(thrown.what(), HasSubstr(error));
    }
  }
}

TEST(ShippedSweeps, CanAllBePlanned) {
  int sweeps = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "sweeps")) {
    SweepFile file = LoadSweepFile(entry.path());
    file.seeds.count = 1;
    EXPECT_FALSE(PlanSweep(file, "program").flights.empty()) << entry.path();
    EXPECT_FALSE(file.description.empty()) << entry.path();
    ++sweeps;
  }
  EXPECT_GE(sweeps, 9);
}

TEST_F(SweepPlanTest, RejectsDuplicateFlightsAndTooMany) {
  const auto error = [&](const std::string& text) -> std::string {
    try {
      Plan(text);
    } catch (const InputError& thrown) {
      return thrown.what();
    }
    return "";
  };
  EXPECT_THAT(error("parameters: {start.position_m: [[0, 0, 1], [0, 0, 1.0]]}"),
              HasSubstr("s.yaml:2: parameters.start.position_m: (start.position_m=[0, 0, 1]) and "
                        "(start.position_m=[0, 0, 1.0]) are the same flight"));
  EXPECT_THAT(
      error("parameters: {camera.noise_sigma: [4]}\nvariants: [{name: a}, {name: b}]"),
      HasSubstr("s.yaml:3: variants: (variant a, camera.noise_sigma=4) and (variant b, camera.noise_sigma=4) are"));
  EXPECT_THAT(error("seeds: {count: 1000}\nparameters: {camera.noise_sigma: {range: {from: 0, to: 1, count: 101}}}"),
              HasSubstr("s.yaml: the sweep has 101000 flights; allowed: at most 100000"));
}

TEST_F(SweepPlanTest, ResolvesFilesRelativeToTheSweepFile) {
  folder_.Put("wide.yaml", "k1: -0.05\n");
  const auto file =
      folder_.Put("sweeps/s.yaml", "base: ../base.yaml\nparameters: {camera.model: [../lens.yaml, ../wide.yaml]}\n");
  const SweepPlan plan = PlanSweep(LoadSweepFile(file), "program");
  ASSERT_EQ(plan.flights.size(), 2u);
  EXPECT_THAT(plan.flights[1].scenario_yaml, HasSubstr("-0.05"));
}

}  // namespace
}  // namespace touchdown::sweeper
