#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// Progress of a sweep in an output directory, also while other programs fly it.
struct SweepStatus {
  std::string name = {};
  std::size_t planned = 0;
  std::size_t total = 0;  ///< Number of flights of the whole sweep, of which the plan may be a part.
  std::size_t flown = 0;
  std::size_t passed = 0;
  /// Number of flights whose process crashed, hung or ran out of memory, by the name of the end.
  std::map<std::string, std::size_t> processes = {};
  std::size_t stale = 0;                      ///< Rows of other builds.
  std::optional<std::string> slurm_job = {};  ///< Id of the newest job.
  /// Number of queued and running tasks of this job, by Slurm's name of the state; nullopt without Slurm.
  std::optional<std::map<std::string, int>> slurm_tasks = {};
};

/// Counts the rows in an output directory and changes nothing. Throws InputError if it contains no sweep.
SweepStatus StatusOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
