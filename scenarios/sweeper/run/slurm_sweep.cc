#include "scenarios/sweeper/run/slurm_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "models/error.h"
#include "scenarios/sweeper/run/flight_chunk.h"
#include "scenarios/sweeper/run/folder_rows.h"
#include "scenarios/sweeper/run/run_sweep.h"
#include "scenarios/util/file.h"
#include "scenarios/util/folder_lock.h"
#include "scenarios/util/output_file.h"
#include "scenarios/util/program_digest.h"
#include "scenarios/util/shell_word.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScriptSignature = "sweep-task";
constexpr const char* kJobSignature = "slurm_job: ";

/// Planned flights without a row in `folder`. With `retry` also those whose process crashed, hung or ran out of memory.
std::vector<const PlannedFlight*> MissingFlights(const SweepPlan& plan, const fs::path& folder, bool retry) {
  std::optional<SweepStore> store;
  if (fs::exists(folder / "sweep.db")) store.emplace(folder, SweepStore::Access::kRead);
  const FolderRows rows(folder, store ? &*store : nullptr);
  std::vector<const PlannedFlight*> missing;
  for (const PlannedFlight& flight : plan.flights) {
    const std::optional<FlightRow> row = rows.Find(flight.id);
    if (!row || (retry && row->process != ProcessEnd::kFlown)) missing.push_back(&flight);
  }
  return missing;
}

/// Number of flights per task. Assumes that flights run at about real time.
std::size_t ChunkSize(const std::vector<const PlannedFlight*>& flights, const SlurmOptions& options, int most_tasks) {
  constexpr double kTask_s = 300.0;
  double flown_s = 0.0;
  for (const PlannedFlight* flight : flights) flown_s += flight->expected_s;
  const double tasks = std::max(1.0, std::floor(flown_s / kTask_s));
  const auto in_tasks = [&](double count) { return std::ceil(static_cast<double>(flights.size()) / count); };
  const double wanted = options.chunk ? static_cast<double>(*options.chunk) : in_tasks(tasks);
  return static_cast<std::size_t>(std::max(wanted, in_tasks(most_tasks)));
}

/// Divides flights into chunks of `size`.
std::vector<FlightChunk> Chunks(const SweepFile& file, const std::vector<const PlannedFlight*>& flights,
                                std::size_t size) {
  std::vector<FlightChunk> chunks;
  for (const PlannedFlight* flight : flights) {
    if (chunks.empty() || chunks.back().flights.size() == size) {
      chunks.push_back({.program = util::ProgramDigest(), .flights = {}});
    }
    chunks.back().flights.push_back({flight->id, flight->scenario_yaml, flight->limit_s, file.limits.memory_mb});
  }
  return chunks;
}

/// Batch script of a job array.
std::string Script(std::size_t tasks) {
  return fmt::format(R"(#!/bin/sh
#SBATCH --job-name=touchdown
#SBATCH --array=0-{}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=slurm/%a.log
exec {} sweep-task . "$SLURM_ARRAY_TASK_ID"
)",
                     tasks - 1, util::ShellWord(fs::read_symlink("/proc/self/exe").string()));
}

fs::path JobFile(const fs::path& folder) { return folder / "slurm" / "job.yaml"; }

/// Throws InputError if a job of the sweep has not ended.
void RejectWhileQueued(const fs::path& folder) {
  const std::optional<std::string> job = SlurmJobOf(folder);
  if (!job) return;
  const auto tasks = TasksInQueue(*job);
  if (tasks && tasks->empty()) return;
  throw InputError(
      tasks ? fmt::format("output folder {}: its Slurm job {} has not ended; see touchdown status, or cancel "
                          "it with scancel {}",
                          folder.string(), *job, *job)
            : fmt::format("output folder {}: squeue does not report whether its Slurm job {} has ended",
                          folder.string(), *job));
}

/// Records the id of a held job. It is released after that, because the next submission would overwrite the tasks of an
/// unrecorded job.
void WriteJob(const fs::path& folder, const std::string& job) {
  try {
    util::WriteOutputFile(JobFile(folder), kJobSignature + job + "\n", kJobSignature);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}; Slurm job {} is submitted and held; cancel it with scancel {}", error.what(), job, job));
  }
}

/// Writes the chunk files of a job, and removes those of an earlier job.
void WriteTasks(const fs::path& folder, const std::vector<FlightChunk>& chunks) {
  std::error_code error;
  fs::remove_all(folder / "tasks", error);
  fs::create_directories(folder / "slurm", error);
  for (std::size_t i = 0; i < chunks.size(); ++i) WriteChunk(ChunkFile(folder, static_cast<int>(i)), chunks[i]);
}

}  // namespace

SlurmSweep PlanTasks(const SweepFile& file, const SweepPlan& plan, const fs::path& folder,
                     const SlurmOptions& options) {
  const int most = MaxArrayTasks();
  RejectWhileQueued(folder);
  const std::vector<const PlannedFlight*> missing = MissingFlights(plan, folder, options.retry);
  return {.tasks = Chunks(file, missing, ChunkSize(missing, options, most)).size(), .flights = missing.size()};
}

SlurmSweep SubmitSweep(const SweepFile& file, const SweepPlan& plan, const fs::path& folder,
                       const SlurmOptions& options) {
  const int most = MaxArrayTasks();
  util::ClaimFolder(folder);
  const util::FolderLock lock(folder);
  RejectWhileQueued(folder);
  SweepStore store(folder, SweepStore::Access::kWrite);
  CollectRows(folder, store);
  store.SetPlan(SpecOf(file), plan, util::ProgramDigest());
  const std::vector<const PlannedFlight*> missing = MissingFlights(plan, folder, options.retry);
  if (missing.empty()) return {};
  const std::vector<FlightChunk> chunks = Chunks(file, missing, ChunkSize(missing, options, most));
  WriteTasks(folder, chunks);
  util::WriteOutputFile(folder / "slurm.sh", Script(chunks.size()), kScriptSignature);
  const std::string job = SubmitHeld(folder / "slurm.sh", fs::absolute(folder), options.site);
  WriteJob(folder, job);
  ReleaseJob(job);
  return {.job = job, .tasks = chunks.size(), .flights = missing.size()};
}

std::optional<std::string> SlurmJobOf(const fs::path& folder) {
  std::istringstream stream(util::ReadTextFileIfPresent(JobFile(folder)).value_or(""));
  std::string key, job;
  if (!(stream >> key >> job)) return std::nullopt;
  return job;
}

}  // namespace touchdown::sweeper
