#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/cli/commands.h"
#include "scenarios/sweeper/run/sweep_status.h"

namespace touchdown::cli {
namespace {

struct StatusOptions {
  std::string folder;
  bool json = false;
};

nlohmann::ordered_json StatusJson(const sweeper::SweepStatus& status) {
  nlohmann::ordered_json json{{"sweep", status.name},          {"planned", status.planned},
                              {"whole", status.total},         {"flown", status.flown},
                              {"passed", status.passed},       {"failed", status.flown - status.passed},
                              {"processes", status.processes}, {"stale", status.stale}};
  if (status.slurm_job) json["slurm_job"] = *status.slurm_job;
  if (status.slurm_tasks) json["slurm_tasks"] = *status.slurm_tasks;
  return json;
}

/// Counts by name as text, for example "2 PENDING, 1 RUNNING".
template <typename Counts>
std::string CountsText(const Counts& counts) {
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  return text;
}

std::string SlurmText(const sweeper::SweepStatus& status) {
  if (!status.slurm_tasks) return "state unknown, squeue is not available";
  return status.slurm_tasks->empty() ? "finished" : "tasks: " + CountsText(*status.slurm_tasks);
}

void PrintStatus(const sweeper::SweepStatus& status) {
  fmt::print("{}: {} of {} flights{}\n", status.name, status.flown, status.planned,
             status.total == status.planned ? "" : fmt::format(" of this part, {} in the whole sweep", status.total));
  fmt::print("  passed {}\n  failed {}{}\n", status.passed, status.flown - status.passed,
             status.processes.empty() ? "" : fmt::format(" ({})", CountsText(status.processes)));
  if (status.stale > 0) fmt::print("  stale  {} (flown by another build)\n", status.stale);
  if (status.slurm_job) fmt::print("Slurm job {}: {}\n", *status.slurm_job, SlurmText(status));
}

int Status(const StatusOptions& options) {
  const sweeper::SweepStatus status = sweeper::StatusOf(options.folder);
  if (options.json) {
    fmt::print("{}\n", StatusJson(status).dump(2));
  } else {
    PrintStatus(status);
  }
  return kPassed;
}

}  // namespace

void AddStatus(CLI::App& app, Run& run) {
  const auto options = std::make_shared<StatusOptions>();
  CLI::App& command = *app.add_subcommand("status", "Print the progress of a sweep, also on a cluster");
  command.add_option("DIR", options->folder, "Output directory of the sweep")->required();
  command.add_flag("--json", options->json, "Print the status as JSON");
  command.callback([options, &run] { run = [options] { return Status(*options); }; });
}

}  // namespace touchdown::cli
