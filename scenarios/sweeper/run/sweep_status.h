#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// How far the sweep in a folder is, whoever flies it.
struct SweepStatus {
  std::string name = {};
  std::size_t planned = 0;
  std::size_t whole = 0;  ///< Flights of the whole sweep, of which these may be a part.
  std::size_t flown = 0;
  std::size_t passed = 0;
  /// Of those that did not pass, how many have a process that crashed, hung or ran out of memory, by these names.
  std::map<std::string, std::size_t> processes = {};
  std::size_t stale = 0;                      ///< Rows that another build flew.
  std::optional<std::string> slurm_job = {};  ///< The last that was submitted.
  /// How many of its tasks are queued or running, by Slurm's word for their state; nullopt when Slurm is not there.
  std::optional<std::map<std::string, int>> slurm_tasks = {};
};

/// Counts what lies in a sweep's folder and changes nothing. Throws InputError when it is no sweep's.
SweepStatus StatusOf(const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
