#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/run/slurm.h"

namespace touchdown::sweeper {

/// How a sweep is to be split and submitted.
struct SlurmOptions {
  /// Flights in a task; default: as many as take some minutes. There are more where an array would be too long.
  std::optional<int> chunk = {};
  SlurmSite site = {};
  bool retry = false;  ///< As SweepOptions has it.
};

/// A sweep as Slurm sees it.
struct SlurmSweep {
  std::string job = {};  ///< Empty when nothing was submitted.
  std::size_t tasks = 0;
  std::size_t flights = 0;  ///< Those that are not flown yet.
};

/// What SubmitSweep would submit. Throws InputError as it does, and writes nothing.
SlurmSweep PlanTasks(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                     const SlurmOptions& options);

/// Keeps a plan in `folder` and submits the flights that have no row there, as an array whose tasks FlyChunk;
/// docs/cluster.md lists the files in the folder. Nothing is submitted when all are there. Throws InputError when
/// the folder is another's or cannot be written, an earlier job of it is not over, or Slurm is not there or refuses.
SlurmSweep SubmitSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
                       const SlurmOptions& options);

/// The job that was submitted last for the sweep in `folder`.
std::optional<std::string> SlurmJobOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
