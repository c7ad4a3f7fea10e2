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
#include "scenarios/sweep/rows_csv.h"
#include "scenarios/sweep/run_sweep.h"
#include "scenarios/sweep/sweep_report.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCsvMark = "id,variant,";

struct Options {
  std::string sweep;
  std::optional<std::string> out, csv, shard;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool dry_run = false;
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
  SweepPlan plan = PlanSweep(file, ProgramDigest());
  if (options.shard) plan = TakeShard(file, plan, *options.shard);
  if (options.dry_run) {
    PrintPlan(plan, options.jobs);
    return kPassed;
  }
  if (!options.out) throw InputError("--out: name a folder for the rows");
  if (options.csv) CheckOutputFile(*options.csv, kCsvMark);
  CheckOutputFile(fs::path(*options.out) / "report.html", kSweepPageMark);
  const bool is_done = FlyAll(file, plan, options);
  const SweepOutcome sweep = ReadOutcome({*options.out, SweepStore::Access::kRead});
  if (options.csv) WriteOutputFile(*options.csv, RowsCsv(sweep.terms.keys(), sweep.results), kCsvMark);
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
  command.add_flag("--dry-run", options->dry_run, "List the flights, and fly none");
  AddTalk(command, options->talk);
  command.callback([options, &run] { run = [options] { return Sweep(*options); }; });
}

}  // namespace touchdown::scenarios
