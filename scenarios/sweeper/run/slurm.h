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

/// How many tasks an array may have at this site. Throws InputError when there is no Slurm, or it does not answer.
int MostSlurmTasks();

/// Submits a script that runs in `folder`, on hold until ReleaseJob, and returns the id of the job. Throws
/// InputError, with what Slurm said, when it is refused.
std::string SubmitHeld(const std::filesystem::path& script, const std::filesystem::path& folder, const SlurmSite& site);

/// Throws InputError, with what Slurm said and what is to be done, when the job stays held.
void ReleaseJob(const std::string& job);

/// How many tasks of a job are in which state, in Slurm's words; none once it is over. nullopt when Slurm is not there
/// or does not answer.
std::optional<std::map<std::string, int>> TasksInQueue(const std::string& job);

}  // namespace touchdown::sweeper
