#include "scenarios/sweeper/run/slurm.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "models/error.h"
#include "scenarios/util/process.h"

namespace touchdown::sweeper {
namespace {

std::string InOneLine(const std::string& text) {
  std::istringstream lines(text);
  std::string joined, line;
  while (std::getline(lines, line)) joined += (joined.empty() ? "" : "; ") + line;
  return joined;
}

/// Output of a Slurm tool.
std::string Ask(const std::vector<std::string>& arguments) {
  const std::optional<util::ProcessResult> run = util::RunProcess(arguments);
  if (!run) throw InputError(fmt::format("--slurm: there is no {} on this machine", arguments[0]));
  if (!run->succeeded) throw InputError(fmt::format("--slurm: {} refuses: {}", arguments[0], InOneLine(run->err)));
  return run->out;
}

}  // namespace

int MostSlurmTasks() {
  const std::string config = Ask({"scontrol", "show", "config"});
  std::smatch found;
  if (!std::regex_search(config, found, std::regex("MaxArraySize\\s*=\\s*([0-9]{1,9})"))) {
    throw InputError("--slurm: scontrol prints no MaxArraySize");
  }
  const int most = std::stoi(found[1]);
  if (most < 1) throw InputError("--slurm: this site takes no job arrays (MaxArraySize is 0)");
  return most;
}

std::string SubmitHeld(const std::filesystem::path& script, const std::filesystem::path& folder,
                       const SlurmSite& site) {
  std::vector<std::string> arguments{"sbatch", "--parsable", "--hold", "--chdir=" + folder.string()};
  if (site.partition) arguments.push_back("--partition=" + *site.partition);
  if (site.account) arguments.push_back("--account=" + *site.account);
  if (site.time) arguments.push_back("--time=" + *site.time);
  arguments.push_back(script.string());
  const std::string out = Ask(arguments);  // "7", or "7;cluster".
  return out.substr(0, out.find_first_of(";\n"));
}

void ReleaseJob(const std::string& job) {
  try {
    Ask({"scontrol", "release", job});
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}; Slurm job {} is submitted and held: scontrol release {} lets it go, scancel {} ends it",
                    error.what(), job, job, job));
  }
}

std::optional<std::map<std::string, int>> TasksInQueue(const std::string& job) {
  const std::optional<util::ProcessResult> run =
      util::RunProcess({"squeue", "--noheader", "--array", "--format=%T", "--jobs=" + job});
  if (!run) return std::nullopt;
  std::map<std::string, int> tasks;
  if (!run->succeeded) {
    const bool is_forgotten = run->err.find("Invalid job id") != std::string::npos;
    return is_forgotten ? std::optional(tasks) : std::nullopt;
  }
  std::istringstream states(run->out);
  for (std::string state; states >> state;) ++tasks[state];
  return tasks;
}

}  // namespace touchdown::sweeper
