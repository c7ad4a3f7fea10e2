#include "scenarios/sweeper/run/flight_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "models/error.h"
#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/run/process_pool.h"
#include "scenarios/util/scratch_folder.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> ScenariosIn(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  if (files.empty()) throw InputError(fmt::format("{}: no scenarios in this folder", folder.string()));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<TestedFlight> TestFlights(const fs::path& folder, int jobs, const util::StopRequested& stop_requested,
                                      const std::function<void(const TestedFlight&)>& on_done) {
  std::vector<TestedFlight> tests;
  std::vector<FlightTask> tasks;
  for (const fs::path& file : ScenariosIn(folder)) {
    tests.push_back({.file = file, .scenario = runner::LoadScenario(file), .row = {}, .checks = {}});
    tasks.push_back({.id = file.stem().string(),
                     .scenario_yaml = runner::ScenarioYaml(tests.back().scenario),
                     .limit_s = DefaultLimit_s(tests.back().scenario)});
  }
  const util::ScratchFolder scratch;
  const RowFolder rows(scratch.path());
  const ProcessPoolOptions pool_options{
      .jobs = jobs, .fly = [&rows](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, rows); }};
  std::size_t next = 0, done = 0;
  const auto report_row = [&](const FlightRow& row) {
    const auto test = std::find_if(tests.begin(), tests.end(),
                                   [&](const TestedFlight& each) { return each.file.stem().string() == row.id; });
    test->row = row;
    test->checks = runner::Judge(test->scenario, row.outcome, row.metrics);
    ++done;
    if (on_done) on_done(*test);
  };
  FlyTasks(
      rows, pool_options, [&] { return next < tasks.size() ? &tasks[next++] : nullptr; }, report_row, stop_requested);
  if (done < tests.size()) throw util::Interrupted();
  return tests;
}

}  // namespace touchdown::sweeper
