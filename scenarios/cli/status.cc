#include "scenarios/cli/status.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/sweeper/run/sweep_status.h"

namespace touchdown::cli {
namespace {

struct StatusOptions {
  std::string folder;
  bool json = false;
};

nlohmann::ordered_json StatusJson(const sweeper::SweepStatus& status) {
  nlohmann::ordered_json json{{"sweep", status.name},          {"planned", status.planned},
                              {"whole", status.whole},         {"flown", status.flown},
                              {"passed", status.passed},       {"failed", status.flown - status.passed},
                              {"processes", status.processes}, {"stale", status.stale}};
  if (status.slurm_job) json["slurm_job"] = *status.slurm_job;
  if (status.slurm_tasks) json["slurm_tasks"] = *status.slurm_tasks;
  return json;
}

/// "2 PENDING, 1 RUNNING"
template <typename Counts>
std::string CountWords(const Counts& counts) {
  std::string words;
  for (const auto& [name, count] : counts) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, name);
  return words;
}

std::string SlurmWords(const sweeper::SweepStatus& status) {
  if (!status.slurm_tasks) return "squeue does not tell";
  return status.slurm_tasks->empty() ? "is over" : "tasks: " + CountWords(*status.slurm_tasks);
}

void PrintStatus(const sweeper::SweepStatus& status) {
  fmt::print("{}: {} of {} flights{}\n", status.name, status.flown, status.planned,
             status.whole == status.planned ? "" : fmt::format(", of {} in the whole sweep", status.whole));
  fmt::print("  passed {}\n  failed {}{}\n", status.passed, status.flown - status.passed,
             status.processes.empty() ? "" : fmt::format(" ({})", CountWords(status.processes)));
  if (status.stale > 0) fmt::print("  stale  {} (flown by another build)\n", status.stale);
  if (status.slurm_job) fmt::print("Slurm job {}: {}\n", *status.slurm_job, SlurmWords(status));
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
  CLI::App& command = *app.add_subcommand("status", "Tell how far a sweep is, wherever it flies");
  command.add_option("DIR", options->folder, "The sweep's folder")->required();
  command.add_flag("--json", options->json, "Print it as JSON");
  command.callback([options, &run] { run = [options] { return Status(*options); }; });
}

}  // namespace touchdown::cli
