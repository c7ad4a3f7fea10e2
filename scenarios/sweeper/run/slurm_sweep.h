#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/run/slurm.h"

namespace touchdown::sweeper {

/// Options of a submission to Slurm.
struct SlurmOptions {
  /// Flights of a task; default: as many as take a few minutes, or more where the array would be too long.
  std::optional<int> chunk = {};
  SlurmSite site = {};
  bool retry = false;  ///< See SweepOptions.
};

/// Submitted job of a sweep.
struct SlurmSweep {
  std::string job = {};  ///< Empty when nothing was submitted.
  std::size_t tasks = 0;
  std::size_t flights = 0;  ///< Flights that are not flown yet.
};

/// Job that SubmitSweep would submit. Throws InputError as it does, and writes nothing.
SlurmSweep PlanTasks(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                     const SlurmOptions& options);

/// Stores a plan in `folder` and submits the flights without a row there, as an array whose tasks FlyChunk;
/// docs/cluster.md lists the files in the folder. Nothing is submitted when all are flown. Throws InputError when the
/// folder belongs to something else or cannot be written, an earlier job of it is not over, or Slurm is missing or
/// refuses the job.
SlurmSweep SubmitSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                       const SlurmOptions& options);

/// Newest job of the sweep in `folder`.
std::optional<std::string> SlurmJobOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
