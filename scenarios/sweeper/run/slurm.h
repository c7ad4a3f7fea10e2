#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// Options of a job that a site may require, as sbatch accepts them.
struct SlurmSite {
  std::optional<std::string> partition = {};
  std::optional<std::string> account = {};
  std::optional<std::string> time = {};
};

/// Largest number of tasks of an array at this site. Throws InputError without Slurm, or without an answer.
int MostSlurmTasks();

/// Submits a script that runs in `folder`, on hold until ReleaseJob, and returns the id of the job. Throws
/// InputError, with Slurm's message, when it is refused.
std::string SubmitHeld(const std::filesystem::path& script, const std::filesystem::path& folder, const SlurmSite& site);

/// Throws InputError, with Slurm's message and the remedy, when the job stays on hold.
void ReleaseJob(const std::string& job);

/// Number of tasks of a job in each state, by Slurm's names; empty once it is over. nullopt when Slurm is missing or
/// does not answer.
std::optional<std::map<std::string, int>> TasksInQueue(const std::string& job);

}  // namespace touchdown::sweeper
