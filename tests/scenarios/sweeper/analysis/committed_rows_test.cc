// docs/sweeps holds the rows of a shipped sweep: the source of the figures in the documentation, and a baseline.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scenarios/sweeper/analysis/rows_csv.h"
#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/run/fly_row.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

/// To remake them: build/release/touchdown sweep scenarios/sweeps/wind.yaml --out out/wind --csv docs/sweeps/wind.csv
TEST(CommittedRows, AreOfTheSweepThatShipsAndFlyAsThisBuildDoes) {
  const fs::path root = TOUCHDOWN_SOURCE_DIR;
  const StoredResults committed = ReadRowsCsv(root / "docs/sweeps/wind.csv");
  const SweepPlan plan = PlanSweep(LoadSweepFile(root / "scenarios/sweeps/wind.yaml"), "program");
  ASSERT_EQ(committed.keys, plan.keys);
  ASSERT_EQ(committed.results.size(), plan.flights.size());
  for (const PlannedFlight& flight : plan.flights) {
    EXPECT_TRUE(std::any_of(
        committed.results.begin(), committed.results.end(),
        [&](const SweepResult& result) { return result.seed == flight.seed && result.values == flight.values; }))
        << flight.seed << " " << flight.values.front();
  }

  const PlannedFlight& calm = plan.flights.front();
  const FlightRow& kept =
      std::find_if(committed.results.begin(), committed.results.end(), [&](const SweepResult& each) {
        return each.seed == calm.seed && each.values == calm.values;
      })->row;
  const tests::TemporaryFolder folder;
  FlyRow(calm.scenario_yaml, "calm", RowFolder(folder.path()));
  const FlightRow flown = RowFolder(folder.path()).Find("calm").value();
  EXPECT_EQ(flown.verdict, kept.verdict);
  // Another type of CPU rounds otherwise, and then the flight is a little another.
  for (const auto& [metric, same] : {std::pair("flight.touchdown_xy_error_m", 0.005), {"flight.landing_time_s", 0.2}}) {
    EXPECT_NEAR(flown.metrics.at(metric), kept.metrics.at(metric), same) << metric;
  }
}

}  // namespace
}  // namespace touchdown::sweeper
