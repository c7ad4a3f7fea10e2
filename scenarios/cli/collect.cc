#include <memory>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/sweep_outcome.h"
#include "scenarios/sweeper/run/collect.h"

namespace touchdown::cli {
namespace {

struct CollectOptions {
  SweepFiles files;
  std::vector<std::string> from;
  OutputOptions output;
};

int CollectRows(const CollectOptions& options) {
  CheckSweepFiles(options.files);
  sweeper::Collect(options.files.folder, {options.from.begin(), options.from.end()});
  const sweeper::SweepSummary summary = ReportOutcome(options.files, options.output);
  return summary.is_complete && summary.meets_criteria() ? kPassed : kFailed;
}

}  // namespace

void AddCollect(CLI::App& app, Run& run) {
  const auto options = std::make_shared<CollectOptions>();
  CLI::App& command =
      *app.add_subcommand("collect", "Merge the rows of a sweep that was flown in parts or on a cluster");
  command
      .add_option("DIR", options->files.folder,
                  "Output directory of the sweep; with FROM it is created if it does not exist")
      ->required();
  command.add_option("FROM", options->from, "Output directories of parts of the sweep (sweep --shard)");
  command.add_option("--csv", options->files.csv, "Write the rows, sorted by id, to this CSV file")->type_name("FILE");
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return CollectRows(*options); }; });
}

}  // namespace touchdown::cli
