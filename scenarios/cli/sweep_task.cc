#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/sweeper/run/flight_chunk.h"

namespace touchdown::cli {
namespace {

struct SweepTaskOptions {
  std::string folder;
  int number = 0;
  int jobs = 1;
};

int FlyTask(const SweepTaskOptions& options) {
  const auto print = [](const sweeper::FlightRow& row) {
    fmt::print("{} {} in {:.1f} s\n", row.id, Name(row.verdict), row.wall_s);
    std::fflush(stdout);
  };
  const bool is_done = sweeper::FlyChunk(options.folder, options.number, options.jobs, InterruptRequested, print);
  return is_done ? kPassed : kInterrupted;
}

}  // namespace

void AddSweepTask(CLI::App& app, Run& run) {
  const auto options = std::make_shared<SweepTaskOptions>();
  CLI::App& command = *app.add_subcommand("sweep-task", "Fly a chunk of a sweep; run by the Slurm tasks");
  command.group("");  // Hide the command from --help: only the tasks that sweep --slurm submits run it.
  command.add_option("DIR", options->folder, "Output directory of the sweep")->required();
  command.add_option("N", options->number, "Index of the chunk, from 0")->required();
  command.add_option("--jobs", options->jobs, "Maximum number of concurrent flights")
      ->type_name("N")
      ->envname("SLURM_CPUS_PER_TASK")
      ->check(CLI::Range(1, 1024));
  command.callback([options, &run] { run = [options] { return FlyTask(*options); }; });
}

}  // namespace touchdown::cli
