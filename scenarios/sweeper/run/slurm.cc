#include "scenarios/sweeper/run/slurm.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "models/error.h"
#include "scenarios/util/process.h"

namespace touchdown::sweeper {
namespace {

/// Joins the lines of a text with semicolons.
std::string InOneLine(const std::string& text) {
  std::istringstream lines(text);
  std::string joined, line;
  while (std::getline(lines, line)) joined += (joined.empty() ? "" : "; ") + line;
  return joined;
}

/// Runs a Slurm tool and returns its output. Throws InputError if the tool is missing or fails.
std::string RunSlurmTool(const std::vector<std::string>& arguments) {
  const std::optional<util::ProcessResult> run = util::RunProcess(arguments);
  if (!run) throw InputError(fmt::format("--slurm: {} not found on this machine", arguments[0]));
  if (!run->succeeded) throw InputError(fmt::format("--slurm: {} failed: {}", arguments[0], InOneLine(run->err)));
  return run->out;
}

}  // namespace

int MaxArrayTasks() {
  const std::string config = RunSlurmTool({"scontrol", "show", "config"});
  std::smatch found;
  if (!std::regex_search(config, found, std::regex("MaxArraySize\\s*=\\s*([0-9]{1,9})"))) {
    throw InputError("--slurm: scontrol does not report MaxArraySize");
  }
  const int most = std::stoi(found[1]);
  if (most < 1) throw InputError("--slurm: this site does not allow job arrays (MaxArraySize is 0)");
  return most;
}

std::string SubmitHeld(const std::filesystem::path& script, const std::filesystem::path& folder,
                       const SlurmSite& site) {
  std::vector<std::string> arguments{"sbatch", "--parsable", "--hold", "--chdir=" + folder.string()};
  if (site.partition) arguments.push_back("--partition=" + *site.partition);
  if (site.account) arguments.push_back("--account=" + *site.account);
  if (site.time) arguments.push_back("--time=" + *site.time);
  arguments.push_back(script.string());
  const std::string out = RunSlurmTool(arguments);  // "7", or "7;cluster".
  return out.substr(0, out.find_first_of(";\n"));
}

void ReleaseJob(const std::string& job) {
  try {
    RunSlurmTool({"scontrol", "release", job});
  } catch (const InputError& error) {
    throw InputError(fmt::format(
        "{}; Slurm job {} is submitted and held; release it with scontrol release {}, or cancel it with scancel {}",
        error.what(), job, job, job));
  }
}

std::optional<std::map<std::string, int>> TasksInQueue(const std::string& job) {
  const std::optional<util::ProcessResult> run =
      util::RunProcess({"squeue", "--noheader", "--array", "--format=%T", "--jobs=" + job});
  if (!run) return std::nullopt;
  std::map<std::string, int> tasks;
  if (!run->succeeded) {
    const bool is_unknown = run->err.find("Invalid job id") != std::string::npos;
    return is_unknown ? std::optional(tasks) : std::nullopt;
  }
  std::istringstream states(run->out);
  for (std::string state; states >> state;) ++tasks[state];
  return tasks;
}

}  // namespace touchdown::sweeper
