#include "scenarios/cli/sweep_task.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

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
  const auto tell = [](const sweeper::FlightRow& row) {
    fmt::print("{} {} in {:.1f} s\n", row.id, Name(row.verdict), row.wall_s);
    std::fflush(stdout);
  };
  const bool is_done = sweeper::FlyChunk(options.folder, options.number, options.jobs, InterruptRequested, tell);
  return is_done ? kPassed : kInterrupted;
}

}  // namespace

void AddSweepTask(CLI::App& app, Run& run) {
  const auto options = std::make_shared<SweepTaskOptions>();
  CLI::App& command = *app.add_subcommand("sweep-task", "Fly a chunk of a sweep, as the tasks on Slurm do");
  command.group("");  // For what sweep --slurm submits, not for people: --help does not list it.
  command.add_option("DIR", options->folder, "The sweep's folder")->required();
  command.add_option("N", options->number, "Which chunk")->required();
  command.add_option("--jobs", options->jobs, "How many fly at a time")
      ->type_name("N")
      ->envname("SLURM_CPUS_PER_TASK")
      ->check(CLI::Range(1, 1024));
  command.callback([options, &run] { run = [options] { return FlyTask(*options); }; });
}

}  // namespace touchdown::cli
