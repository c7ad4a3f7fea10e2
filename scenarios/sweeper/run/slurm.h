#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// Job options that a site may require, in the syntax of sbatch.
struct SlurmSite {
  std::optional<std::string> partition = {};
  std::optional<std::string> account = {};
  std::optional<std::string> time = {};
};

/// Largest number of tasks of a job array at this site. Throws InputError if Slurm is missing or does not answer.
int MaxArrayTasks();

/// Submits a script that runs in `folder` and is held until ReleaseJob. Returns the id of the job. Throws InputError,
/// with Slurm's message, if Slurm rejects it.
std::string SubmitHeld(const std::filesystem::path& script, const std::filesystem::path& folder, const SlurmSite& site);

/// Releases a held job. Throws InputError, with Slurm's message and the remedy, if the job remains held.
void ReleaseJob(const std::string& job);

/// Number of tasks of a job by state, with Slurm's names of the states; empty if the job has ended. nullopt if Slurm is
/// missing or does not answer.
std::optional<std::map<std::string, int>> TasksInQueue(const std::string& job);

}  // namespace touchdown::sweeper
