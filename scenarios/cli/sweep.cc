#include "scenarios/cli/sweep.h"

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
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output.h"
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

void RefuseToSplit(const sweeper::SweepFile& file, const char* option) {
  if (!file.stop_when) return;
  throw InputError(
      fmt::format("{}: a sweep with stop_when cannot be split, since each flight may be the last", option));
}

/// "3/8": the third of eight.
sweeper::SweepPlan TakeShard(const sweeper::SweepFile& file, const sweeper::SweepPlan& plan, const std::string& text) {
  int number = 0, shards = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &number, &shards, &rest) != 2 || number < 1 || number > shards) {
    throw InputError(fmt::format("--shard {}: must be I/N with I from 1 to N", text));
  }
  RefuseToSplit(file, "--shard");
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
                             if (!has_begun) progress.GoOnFrom(done.share);
                             has_begun = true;
                             if (!progress.IsDue()) return;
                             constexpr double kPercent = 100.0;
                             const double rate = done.done > 0 ? kPercent * done.passed / done.done : 0.0;
                             progress.Tell(done.share, fmt::format("{} of {} flights, {:.1f} % passed, {} flying",
                                                                   done.done, done.planned, rate, done.flying));
                           });
}

/// Whether it came to its end.
bool SeekBoundary(const sweeper::SweepFile& file, const SweepOptions& options) {
  Progress progress(!options.output.ForPeople());
  const sweeper::BoundarySearch search{
      .key = *options.boundary, .pass_rate = options.level, .flights = options.flights};
  const sweeper::Boundary found = sweeper::FindBoundary(
      file, search, *options.out, options.jobs, InterruptRequested, [&](const sweeper::Boundary& so_far) {
        if (!progress.IsDue()) return;
        progress.Tell(
            static_cast<double>(so_far.flights) / options.flights,
            fmt::format("{:.4g} (95 %: {:.4g} to {:.4g})", so_far.edge.value, so_far.edge.low, so_far.edge.high));
      });
  return found.is_done;
}

std::string TaskWords(const sweeper::SlurmSweep& sweep) {
  return fmt::format("{} flights in {} task{}", sweep.flights, sweep.tasks, sweep.tasks == 1 ? "" : "s");
}

int SweepOnSlurm(const sweeper::SweepFile& file, const sweeper::SweepPlan& plan, const SweepOptions& options) {
  if (!options.out) throw InputError("--out: name a folder that all nodes share");
  RefuseToSplit(file, "--slurm");
  const sweeper::SlurmOptions on_slurm{.chunk = options.chunk, .site = options.site, .retry = options.retry};
  if (options.dry_run) {
    const sweeper::SlurmSweep planned = sweeper::PlanTasks(file, plan, *options.out, on_slurm);
    fmt::print("{}\n", TaskWords(planned));
    return kPassed;
  }
  const sweeper::SlurmSweep submitted = sweeper::SubmitSweep(file, plan, *options.out, on_slurm);
  if (options.output.quiet) return kPassed;
  if (submitted.flights == 0) {
    fmt::print("{}: all {} flights are there, nothing was submitted\n", file.name, plan.flights.size());
  } else {
    fmt::print("Slurm job {}: {}\n", submitted.job, TaskWords(submitted));
  }
  return kPassed;
}

void AddSlurmOptions(CLI::App& command, SweepOptions& options) {
  constexpr const char* kGroup = "Slurm";
  CLI::Option* const slurm =
      command.add_flag("--slurm", options.slurm, "Submit the flights instead of flying them here");
  slurm->group(kGroup);
  for (const char* here : {"--jobs", "--csv", "--json", "--boundary"}) slurm->excludes(command.get_option(here));
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return command.add_option(name, value, text)->type_name(type)->group(kGroup)->needs(slurm);
  };
  add("--chunk", options.chunk, "K", "Flights in a task (default: some minutes' worth)")->check(CLI::Range(1, 1000000));
  add("--partition", options.site.partition, "P", "As of sbatch");
  add("--account", options.site.account, "A", "As of sbatch");
  add("--time", options.site.time, "T", "A task's time limit, as of sbatch");
}

/// Flies the plan, or seeks the boundary, and tells of it.
int FlyAndReport(const SweepOptions& options, const std::function<bool()>& fly) {
  if (!options.out) throw InputError("--out: name a folder for the rows");
  const SweepFiles files{.folder = *options.out, .csv = options.csv};
  CheckSweepFiles(files);
  const bool is_done = fly();
  const sweeper::SweepSummary summary = ReportOutcome(files, options.output);
  if (!is_done) {
    spdlog::warn("interrupted: what was flown is kept in {}, and the same command goes on from there", *options.out);
    return kInterrupted;
  }
  if (options.boundary) return summary.finds_edge() ? kPassed : kFailed;
  const bool is_part = options.shard.has_value();  // What the whole must show is not asked of a part.
  return is_part || summary.keeps_criteria() ? kPassed : kFailed;
}

int Sweep(const SweepOptions& options) {
  const sweeper::SweepFile file = sweeper::LoadSweepFile(options.sweep);
  if (options.boundary) return FlyAndReport(options, [&] { return SeekBoundary(file, options); });
  sweeper::SweepPlan plan = sweeper::PlanSweep(file, util::ProgramDigest());
  if (options.shard) plan = TakeShard(file, plan, *options.shard);
  if (options.slurm) return SweepOnSlurm(file, plan, options);
  if (options.dry_run) return PrintPlan(plan, options);
  return FlyAndReport(options, [&] { return FlyAll(file, plan, options); });
}

}  // namespace

void AddSweep(CLI::App& app, Run& run) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command = *app.add_subcommand("sweep", "Fly a scenario over parameters and seeds");
  command.add_option("SWEEP", options->sweep, "The sweep's YAML file")->required();
  command.add_option("--out", options->out, "Folder for the rows; flights that are there already are not flown again")
      ->type_name("DIR");
  command.add_option("--jobs", options->jobs, "How many fly at a time (default: a job for each core)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_option("--csv", options->csv, "File for the rows as CSV, sorted by id")->type_name("FILE");
  command.add_option("--shard", options->shard, "Fly the I-th of N parts, into a folder of its own")->type_name("I/N");
  CLI::Option* const boundary =
      command
          .add_option(
              "--boundary", options->boundary,
              "In place of the grid: find the value of this parameter at which the pass rate goes through a level, "
              "between its least and its largest listed value")
          ->type_name("KEY")
          ->excludes("--shard");
  command.add_option("--level", options->level, "The pass rate at the boundary (default: 0.5)")
      ->type_name("SHARE")
      ->check(CLI::Range(0.01, 0.99))
      ->needs(boundary);
  command.add_option("--flights", options->flights, "How many flights a boundary may take (default: 60)")
      ->type_name("N")
      ->check(CLI::Range(6, 100000))
      ->needs(boundary);
  CLI::Option* const dry_run = command.add_flag(
      "--dry-run", options->dry_run, "List the flights and how long they take, and fly none; with --out those to go");
  dry_run->excludes(boundary)->excludes("--csv");
  command.add_flag("--retry", options->retry, "Fly those again whose process crashed, hung or ran out of memory")
      ->excludes(dry_run)
      ->excludes(boundary);
  AddOutputOptions(command, options->output);
  AddSlurmOptions(command, *options);
  command.callback([options, &run] { run = [options] { return Sweep(*options); }; });
}

}  // namespace touchdown::cli
