#include "scenarios/cli/collect.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/flight/output_file.h"
#include "scenarios/sweep/collect.h"
#include "scenarios/sweep/rows_csv.h"

namespace touchdown::scenarios {
namespace {

struct Options {
  std::string folder;
  std::vector<std::string> from;
  std::optional<std::string> csv;
};

/// Of what is planned, and of parts that were not given: positions between others that nothing is planned at.
void PrintMissing(const SweepStore& store, std::size_t flown) {
  const SweepPlan plan = store.Plan();
  fmt::print("{}: {} of {} flights", store.terms().name, flown, plan.flights.size());
  if (flown < plan.flights.size()) fmt::print(", {} missing", plan.flights.size() - flown);
  fmt::print("\n");
  const std::size_t whole = plan.flights.empty() ? 0 : static_cast<std::size_t>(plan.flights.back().position) + 1;
  if (whole > plan.flights.size()) {
    fmt::print("  {} more are in parts of the sweep that are not here\n", whole - plan.flights.size());
  }
}

int CollectRows(const Options& options) {
  if (options.csv) CheckOutputFile(*options.csv, kRowsCsvMark);
  Collect(options.folder, {options.from.begin(), options.from.end()});
  const SweepStore store(options.folder, SweepStore::Access::kRead);
  const std::vector<SweepResult> results = store.Results();
  if (options.csv) WriteOutputFile(*options.csv, RowsCsv(store.terms().keys(), results), kRowsCsvMark);
  PrintMissing(store, results.size());
  return kPassed;
}

}  // namespace

void AddCollect(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("collect", "Bring the rows of a sweep together that flew elsewhere");
  command.add_option("DIR", options->folder, "The sweep's folder; with FROM it is made when it is not there")
      ->required();
  command.add_option("FROM", options->from, "Folders of parts of the sweep (sweep --shard)");
  command.add_option("--csv", options->csv, "File for the rows as CSV, sorted by id")->type_name("FILE");
  command.callback([options, &run] { run = [options] { return CollectRows(*options); }; });
}

}  // namespace touchdown::scenarios
