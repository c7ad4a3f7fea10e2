#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// Progress of the sweep in a folder, whichever program flies it.
struct SweepStatus {
  std::string name = {};
  std::size_t planned = 0;
  std::size_t whole = 0;  ///< Flights of the whole sweep; the plan may be a part of it.
  std::size_t flown = 0;
  std::size_t passed = 0;
  /// Counts of flights whose process crashed, hung or ran out of memory, by name.
  std::map<std::string, std::size_t> processes = {};
  std::size_t stale = 0;                      ///< Rows of other builds.
  std::optional<std::string> slurm_job = {};  ///< Id of the newest job.
  /// Number of its queued and running tasks, by Slurm's name of the state; nullopt without Slurm.
  std::optional<std::map<std::string, int>> slurm_tasks = {};
};

/// Counts the rows in a sweep's folder and changes nothing. Throws InputError for a folder without a sweep.
SweepStatus StatusOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
