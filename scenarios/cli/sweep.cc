#include "scenarios/cli/sweep.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <thread>

#include "models/error.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/progress.h"
#include "scenarios/cli/talk.h"
#include "scenarios/flight/output_file.h"
#include "scenarios/flight/program_digest.h"
#include "scenarios/sweep/boundary.h"
#include "scenarios/sweep/rows_csv.h"
#include "scenarios/sweep/run_sweep.h"
#include "scenarios/sweep/slurm_sweep.h"
#include "scenarios/sweep/sweep_report.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string sweep;
  std::optional<std::string> out, csv, shard;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool dry_run = false;
  std::optional<std::string> boundary;
  double level = 0.5;
  int flights = 60;
  bool slurm = false;
  SlurmOptions on_slurm;
  Talk talk;
};

/// "3/8": the third of eight.
SweepPlan TakeShard(const SweepFile& file, const SweepPlan& plan, const std::string& text) {
  int number = 0, shards = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &number, &shards, &rest) != 2 || number < 1 || number > shards) {
    throw InputError(fmt::format("--shard {}: must be I/N with I from 1 to N", text));
  }
  if (file.stop_when)
    throw InputError("--shard: a sweep with stop_when cannot be split, since each flight may be the last");
  return ShardOf(plan, number - 1, shards);
}

/// Simulated time of what is planned, and about how long it takes: a flight keeps a core, in about real time.
void PrintPlan(const SweepPlan& plan, int jobs) {
  for (const PlannedFlight& flight : plan.flights) {
    std::string line = fmt::format("{}  seed {}", flight.id, flight.seed);
    if (!flight.variant.empty()) line += "  " + flight.variant;
    for (std::size_t i = 0; i < plan.keys.size(); ++i) line += fmt::format("  {}={}", plan.keys[i], flight.values[i]);
    fmt::print("{}\n", line);
  }
  const double flown_s =
      std::accumulate(plan.flights.begin(), plan.flights.end(), 0.0,
                      [](double sum, const PlannedFlight& flight) { return sum + flight.expected_s; });
  fmt::print("{} flights, {:.0f} s in the air; at real time on {} cores {:.1f} min\n", plan.flights.size(), flown_s,
             jobs, flown_s / 60.0 / jobs);
}

std::string Percent(const PassCount& count) {
  constexpr double kPercent = 100.0;
  const Interval rate = count.rate();
  return fmt::format("{:5.1f} %  ({} of {}; 95 %: {:.1f} to {:.1f})", kPercent * rate.value, count.passed, count.flown,
                     kPercent * rate.low, kPercent * rate.high);
}

void PrintSummary(const SweepOutcome& sweep, const SweepSummary& summary, const std::string& out) {
  fmt::print("{}: {} of {} flights\n", sweep.terms.name, summary.all.flown, sweep.planned);
  if (summary.all.flown > 0) fmt::print("  passed  {}\n", Percent(summary.all));
  for (const PassCountOf& each : summary.by_value) {
    fmt::print("  {:<40} {}\n", fmt::format("{}={}", each.key, each.value), Percent(each.count));
  }
  for (const Check& check : summary.criteria) {
    fmt::print("  {}  {:<40} {:>10} {:<4} {}\n", check.pass ? "pass" : "FAIL", check.name,
               check.value ? fmt::format("{:.4g}", *check.value) : "none", check.unit, check.limit);
  }
  fmt::print("rows in {0}/sweep.db, report in {0}/report.html\n", out);
}

bool FlyAll(const SweepFile& file, const SweepPlan& plan, const Options& options) {
  Progress progress(!options.talk.ForPeople());
  return RunSweep(file, plan, *options.out, options.jobs, InterruptRequested, [&](const SweepProgress& done) {
    if (!progress.IsDue()) return;
    progress.Tell(done.share, fmt::format("{} of {} flights, {} passed", done.done, done.planned, done.passed));
  });
}

int SeekBoundary(const SweepFile& file, const Options& options) {
  if (!options.out) throw InputError("--out: name a folder for the rows");
  Progress progress(!options.talk.ForPeople());
  const BoundarySearch search{.key = *options.boundary, .pass_rate = options.level, .flights = options.flights};
  const auto text = [](const Boundary& b) {
    return fmt::format("{:.4g} (95 %: {:.4g} to {:.4g})", b.edge.value, b.edge.low, b.edge.high);
  };
  const Boundary found =
      FindBoundary(file, search, *options.out, options.jobs, InterruptRequested, [&](const Boundary& so_far) {
        if (progress.IsDue()) progress.Tell(static_cast<double>(so_far.flights) / options.flights, text(so_far));
      });
  if (!found.is_done) {
    spdlog::warn("interrupted: what was flown is kept in {}, and the same command goes on from there", *options.out);
    return kInterrupted;
  }
  if (options.talk.ForPeople()) {
    fmt::print("{}: the pass rate goes through {} at {} = {}, after {} flights\n", file.name, options.level,
               *options.boundary, text(found), found.flights);
    if (found.edge.low == found.min || found.edge.high == found.max)
      fmt::print("it may lie beyond the listed values\n");
  }
  return kPassed;
}

std::string TaskWords(const SlurmSweep& sweep) {
  return fmt::format("{} flights in {} task{}", sweep.flights, sweep.tasks, sweep.tasks == 1 ? "" : "s");
}

int SweepOnSlurm(const SweepFile& file, const SweepPlan& plan, const Options& options) {
  if (!options.out) throw InputError("--out: name a folder that all nodes share");
  if (file.stop_when)
    throw InputError("--slurm: a sweep with stop_when cannot be split, since each flight may be the last");
  if (options.dry_run) {
    const SlurmSweep planned = PlanTasks(file, plan, *options.out, options.on_slurm);
    fmt::print("{}\n", TaskWords(planned));
    return kPassed;
  }
  const SlurmSweep submitted = SubmitSweep(file, plan, *options.out, options.on_slurm);
  if (options.talk.quiet) return kPassed;
  if (submitted.flights == 0) {
    fmt::print("{}: all {} flights are there, nothing was submitted\n", file.name, plan.flights.size());
  } else {
    fmt::print("Slurm job {}: {}\n", submitted.job, TaskWords(submitted));
  }
  return kPassed;
}

void AddSlurmOptions(CLI::App& command, Options& options) {
  constexpr const char* kGroup = "Slurm";
  CLI::Option* const slurm =
      command.add_flag("--slurm", options.slurm, "Submit the flights instead of flying them here");
  slurm->group(kGroup);
  for (const char* here : {"--jobs", "--csv", "--json"}) slurm->excludes(command.get_option(here));
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return command.add_option(name, value, text)->type_name(type)->group(kGroup)->needs(slurm);
  };
  add("--chunk", options.on_slurm.chunk, "K", "Flights in a task (default: some minutes' worth)")
      ->check(CLI::Range(1, 1000000));
  add("--partition", options.on_slurm.site.partition, "P", "As of sbatch");
  add("--account", options.on_slurm.site.account, "A", "As of sbatch");
  add("--time", options.on_slurm.site.time, "T", "A task's time limit, as of sbatch");
}

/// A page that cannot be drawn does not make a sweep of hours fail.
void WriteReport(const SweepOutcome& sweep, const fs::path& folder) {
  std::string page;
  try {
    page = SweepPage(sweep, folder);
  } catch (const InputError& error) {
    spdlog::warn("no report: {}", error.what());
    return;
  }
  WriteOutputFile(folder / "report.html", page, kSweepPageMark);
}

int Sweep(const Options& options) {
  const SweepFile file = LoadSweepFile(options.sweep);
  if (options.boundary) return SeekBoundary(file, options);
  SweepPlan plan = PlanSweep(file, ProgramDigest());
  if (options.shard) plan = TakeShard(file, plan, *options.shard);
  if (options.slurm) return SweepOnSlurm(file, plan, options);
  if (options.dry_run) {
    PrintPlan(plan, options.jobs);
    return kPassed;
  }
  if (!options.out) throw InputError("--out: name a folder for the rows");
  if (options.csv) CheckOutputFile(*options.csv, kRowsCsvMark);
  CheckOutputFile(fs::path(*options.out) / "report.html", kSweepPageMark);
  const bool is_done = FlyAll(file, plan, options);
  const SweepOutcome sweep = ReadOutcome({*options.out, SweepStore::Access::kRead});
  if (options.csv) WriteOutputFile(*options.csv, RowsCsv(sweep.terms.keys(), sweep.results), kRowsCsvMark);
  WriteReport(sweep, *options.out);
  const SweepSummary summary = Summarize(sweep);
  if (options.talk.ForPeople()) PrintSummary(sweep, summary, *options.out);
  if (!is_done) {
    spdlog::warn("interrupted: what was flown is kept in {}, and the same command goes on from there", *options.out);
    return kInterrupted;
  }
  return summary.keeps_criteria() ? kPassed : kFailed;
}

}  // namespace

void AddSweep(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("sweep", "Fly a scenario over parameters and seeds");
  command.add_option("SWEEP", options->sweep, "The sweep's YAML file")->required();
  command.add_option("--out", options->out, "Folder for the rows; flights that are there already are not flown again")
      ->type_name("DIR");
  command.add_option("--jobs", options->jobs, "How many fly at a time (default: a job for each core)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_option("--csv", options->csv, "File for the rows as CSV, sorted by id")->type_name("FILE");
  command.add_option("--shard", options->shard, "Fly the I-th of N parts, into a folder of its own")->type_name("I/N");
  command
      .add_option("--boundary", options->boundary,
                  "In place of the grid: find the value of this parameter at which the pass rate goes through a level, "
                  "between its least and its largest listed value")
      ->type_name("KEY")
      ->excludes("--shard")
      ->excludes("--csv");
  command.add_option("--level", options->level, "The pass rate at the boundary (default: 0.5)")
      ->type_name("SHARE")
      ->check(CLI::Range(0.01, 0.99));
  command.add_option("--flights", options->flights, "How many flights a boundary may take (default: 60)")
      ->type_name("N")
      ->check(CLI::Range(6, 100000));
  command.add_flag("--dry-run", options->dry_run, "List the flights, and fly none");
  AddTalk(command, options->talk);
  AddSlurmOptions(command, *options);
  command.callback([options, &run] { run = [options] { return Sweep(*options); }; });
}

}  // namespace touchdown::scenarios
