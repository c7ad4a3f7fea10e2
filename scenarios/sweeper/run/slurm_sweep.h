#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/run/slurm.h"

namespace touchdown::sweeper {

/// Options of a submission to Slurm.
struct SlurmOptions {
  /// Flights per task. Default: enough for a few minutes, or more if the site allows fewer tasks.
  std::optional<int> chunk = {};
  SlurmSite site = {};
  bool retry = false;  ///< See SweepOptions::retry.
};

/// A submitted job of a sweep.
struct SlurmSweep {
  std::string job = {};  ///< Empty when nothing was submitted.
  std::size_t tasks = 0;
  std::size_t flights = 0;  ///< Number of flights in the tasks.
};

/// Returns the job that SubmitSweep would submit, and writes nothing. Throws InputError as SubmitSweep does.
SlurmSweep PlanTasks(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                     const SlurmOptions& options);

/// Stores a plan in the output directory `folder` and submits the flights without a row as a job array, whose tasks
/// call FlyChunk; docs/cluster.md lists the files in `folder`. Submits nothing if all flights are flown. Throws
/// InputError if `folder` contains something else or cannot be written, if an earlier job in it has not ended, or if
/// Slurm is missing or rejects the job.
SlurmSweep SubmitSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                       const SlurmOptions& options);

/// Id of the newest job of the sweep in `folder`; nullopt if there is none.
std::optional<std::string> SlurmJobOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
