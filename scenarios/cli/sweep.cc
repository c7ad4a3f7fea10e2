#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/cli/progress.h"
#include "scenarios/cli/sweep_outcome.h"
#include "scenarios/cli/sweep_text.h"
#include "scenarios/sweeper/run/boundary.h"
#include "scenarios/sweeper/run/run_sweep.h"
#include "scenarios/sweeper/run/slurm_sweep.h"
#include "scenarios/util/program_digest.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  std::string sweep;
  std::optional<std::string> out, csv, shard;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool dry_run = false;
  std::optional<std::string> boundary;
  double level = 0.5;
  int flights = 60;
  bool slurm = false;
  std::optional<int> chunk;
  sweeper::SlurmSite site;
  bool retry = false;
  OutputOptions output;
};

void RequireSplittable(const sweeper::SweepFile& file, const char* option) {
  if (!file.stop_when) return;
  throw InputError(
      fmt::format("{}: a sweep with stop_when cannot be split, because any flight may be the last", option));
}

/// Selects part I of N, given as "I/N". Throws InputError.
sweeper::SweepPlan SelectShard(const sweeper::SweepFile& file, const sweeper::SweepPlan& plan,
                               const std::string& text) {
  int number = 0, shards = 0;
  char trailing = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &number, &shards, &trailing) != 2 || number < 1 || number > shards) {
    throw InputError(fmt::format("--shard {}: must be I/N with I from 1 to N", text));
  }
  RequireSplittable(file, "--shard");
  return sweeper::ShardOf(plan, number - 1, shards);
}

int PrintPlan(const sweeper::SweepPlan& plan, const SweepOptions& options) {
  std::optional<sweeper::SweepStore> rows;
  if (options.out && fs::exists(fs::path(*options.out) / "sweep.db"))
    rows.emplace(*options.out, sweeper::SweepStore::Access::kRead);
  const DryRun dry_run = MakeDryRun(plan, options.jobs, rows ? &*rows : nullptr);
  if (!options.output.quiet) fmt::print("{}", options.output.json ? DryRunJson(dry_run) : DryRunText(dry_run));
  return kPassed;
}

bool FlyAll(const sweeper::SweepFile& file, const sweeper::SweepPlan& plan, const SweepOptions& options) {
  Progress progress(!options.output.ForPeople());
  bool has_begun = false;
  return sweeper::RunSweep(file, plan, *options.out, {.jobs = options.jobs, .retry = options.retry}, InterruptRequested,
                           [&](const sweeper::SweepProgress& done) {
                             if (!has_begun) progress.StartFrom(done.fraction);
                             has_begun = true;
                             if (!progress.IsDue()) return;
                             constexpr double kPercent = 100.0;
                             const double rate = done.done > 0 ? kPercent * done.passed / done.done : 0.0;
                             progress.Update(done.fraction, fmt::format("{} of {} flights, {:.1f} % passed, {} flying",
                                                                        done.done, done.planned, rate, done.flying));
                           });
}

/// Searches for the pass boundary. Returns whether the search completed, false if interrupted.
bool SearchBoundary(const sweeper::SweepFile& file, const SweepOptions& options) {
  Progress progress(!options.output.ForPeople());
  const sweeper::BoundarySearch search{
      .key = *options.boundary, .pass_rate = options.level, .flights = options.flights};
  const sweeper::Boundary found = sweeper::FindBoundary(
      file, search, *options.out, options.jobs, InterruptRequested, [&](const sweeper::Boundary& so_far) {
        if (!progress.IsDue()) return;
        progress.Update(static_cast<double>(so_far.flights) / options.flights,
                        fmt::format("{:.4g} (95 %: {:.4g} to {:.4g})", so_far.interval.value, so_far.interval.low,
                                    so_far.interval.high));
      });
  return found.is_done;
}

std::string TasksText(const sweeper::SlurmSweep& sweep) {
  return fmt::format("{} flights in {} task{}", sweep.flights, sweep.tasks, sweep.tasks == 1 ? "" : "s");
}

int SweepOnSlurm(const sweeper::SweepFile& file, const sweeper::SweepPlan& plan, const SweepOptions& options) {
  if (!options.out) throw InputError("--out: required; give a directory that all nodes share");
  RequireSplittable(file, "--slurm");
  const sweeper::SlurmOptions on_slurm{.chunk = options.chunk, .site = options.site, .retry = options.retry};
  if (options.dry_run) {
    const sweeper::SlurmSweep planned = sweeper::PlanTasks(file, plan, *options.out, on_slurm);
    fmt::print("{}\n", TasksText(planned));
    return kPassed;
  }
  const sweeper::SlurmSweep submitted = sweeper::SubmitSweep(file, plan, *options.out, on_slurm);
  if (options.output.quiet) return kPassed;
  if (submitted.flights == 0) {
    fmt::print("{}: all {} flights are flown, nothing was submitted\n", file.name, plan.flights.size());
  } else {
    fmt::print("Slurm job {}: {}\n", submitted.job, TasksText(submitted));
  }
  return kPassed;
}

void AddSlurmOptions(CLI::App& command, SweepOptions& options) {
  constexpr const char* kGroup = "Slurm";
  CLI::Option* const slurm = command.add_flag(
      "--slurm", options.slurm, "Submit the flights as a Slurm job instead of flying them on this computer");
  slurm->group(kGroup);
  for (const char* option : {"--jobs", "--csv", "--json", "--boundary"}) slurm->excludes(command.get_option(option));
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return command.add_option(name, value, text)->type_name(type)->group(kGroup)->needs(slurm);
  };
  add("--chunk", options.chunk, "K", "Flights per task (default: as many as take a few minutes)")
      ->check(CLI::Range(1, 1000000));
  add("--partition", options.site.partition, "P", "Partition, passed to sbatch");
  add("--account", options.site.account, "A", "Account, passed to sbatch");
  add("--time", options.site.time, "T", "Time limit of a task, passed to sbatch");
}

/// Runs `fly`, which returns whether it completed, and reports the rows in the output directory. Returns an ExitStatus.
int FlyAndReport(const SweepOptions& options, const std::function<bool()>& fly) {
  if (!options.out) throw InputError("--out: required; give an output directory");
  const SweepFiles files{.folder = *options.out, .csv = options.csv};
  CheckSweepFiles(files);
  const bool is_done = fly();
  const sweeper::SweepSummary summary = ReportOutcome(files, options.output);
  if (!is_done) {
    spdlog::warn("interrupted: the flown rows are kept in {}; the same command resumes from there", *options.out);
    return kInterrupted;
  }
  if (options.boundary) return summary.finds_boundary() ? kPassed : kFailed;
  const bool is_part = options.shard.has_value();  // The criteria apply to the whole sweep only.
  return is_part || summary.meets_criteria() ? kPassed : kFailed;
}

int Sweep(const SweepOptions& options) {
  const sweeper::SweepFile file = sweeper::LoadSweepFile(options.sweep);
  if (options.boundary) return FlyAndReport(options, [&] { return SearchBoundary(file, options); });
  sweeper::SweepPlan plan = sweeper::PlanSweep(file, util::ProgramDigest());
  if (options.shard) plan = SelectShard(file, plan, *options.shard);
  if (options.slurm) return SweepOnSlurm(file, plan, options);
  if (options.dry_run) return PrintPlan(plan, options);
  return FlyAndReport(options, [&] { return FlyAll(file, plan, options); });
}

}  // namespace

void AddSweep(CLI::App& app, Run& run) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command = *app.add_subcommand("sweep", "Fly a scenario over parameters, variants and seeds");
  command.add_option("SWEEP", options->sweep, "YAML file of the sweep")->required();
  command.add_option("--out", options->out, "Output directory; flights whose rows it contains are not flown again")
      ->type_name("DIR");
  command.add_option("--jobs", options->jobs, "Maximum number of concurrent flights (default: the number of cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_option("--csv", options->csv, "Write the rows, sorted by id, to this CSV file")->type_name("FILE");
  command.add_option("--shard", options->shard, "Fly only part I of N; each part needs its own output directory")
      ->type_name("I/N");
  CLI::Option* const boundary =
      command
          .add_option(
              "--boundary", options->boundary,
              "Instead of flying the grid, search for the value of this parameter at which the pass rate crosses "
              "--level, between its smallest and its largest listed value")
          ->type_name("KEY")
          ->excludes("--shard");
  command.add_option("--level", options->level, "Pass rate at the boundary (default: 0.5)")
      ->type_name("RATE")
      ->check(CLI::Range(0.01, 0.99))
      ->needs(boundary);
  command.add_option("--flights", options->flights, "Maximum number of flights of the boundary search (default: 60)")
      ->type_name("N")
      ->check(CLI::Range(6, 100000))
      ->needs(boundary);
  CLI::Option* const dry_run = command.add_flag(
      "--dry-run", options->dry_run,
      "List the flights and their expected duration without flying; with --out, exclude flown ones from the duration");
  dry_run->excludes(boundary)->excludes("--csv");
  command
      .add_flag("--retry", options->retry, "Fly those flights again whose process crashed, hung or ran out of memory")
      ->excludes(dry_run)
      ->excludes(boundary);
  AddOutputOptions(command, options->output);
  AddSlurmOptions(command, *options);
  command.callback([options, &run] { run = [options] { return Sweep(*options); }; });
}

}  // namespace touchdown::cli
