#include "scenarios/cli/paper.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output.h"
#include "scenarios/cli/progress.h"
#include "scenarios/experiments/reproduce_paper.h"

namespace touchdown::cli {
namespace {

struct PaperOptions {
  std::string out;
  bool quick = false;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  OutputOptions output;
};

void PrintSummary(const std::vector<experiments::ComparedQuantity>& compared, const std::string& out) {
  fmt::print("{:<58} {:>10} {:>10}\n", "", "published", "ours");
  const auto figure = [](const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "-"; };
  for (const experiments::ComparedQuantity& row : compared) {
    fmt::print("{} {:<56} {:>10} {:>10} {:<4} {}\n", row.IsKept() ? " " : "!", row.quantity, figure(row.published),
               figure(row.ours), row.unit, row.spread);
  }
  fmt::print("{} of {} above the published; report in {}/report.html\n",
             std::count_if(compared.begin(), compared.end(),
                           [](const experiments::ComparedQuantity& row) { return !row.IsKept(); }),
             std::count_if(compared.begin(), compared.end(),
                           [](const experiments::ComparedQuantity& row) { return row.published.has_value(); }),
             out);
}

experiments::Json SummaryJson(const std::vector<experiments::ComparedQuantity>& compared) {
  experiments::Json rows = experiments::Json::array();
  for (const experiments::ComparedQuantity& row : compared) {
    rows.push_back({{"quantity", row.quantity},
                    {"unit", row.unit},
                    {"published", nullptr},
                    {"ours", nullptr},
                    {"kept", nullptr},
                    {"spread", row.spread}});
    if (row.ours) rows.back()["ours"] = *row.ours;
    if (!row.published) continue;
    rows.back()["published"] = *row.published;
    rows.back()["kept"] = row.IsKept();
  }
  return rows;
}

std::vector<experiments::ComparedQuantity> ReproduceWithProgress(const PaperOptions& options) {
  Progress progress(!options.output.ForPeople());
  return experiments::ReproducePaper(options.out, {.quick = options.quick, .jobs = options.jobs}, InterruptRequested,
                                     [&](double share, const std::string& text) {
                                       if (progress.IsDue()) progress.Tell(share, text);
                                     });
}

int Reproduce(const PaperOptions& options) {
  try {
    const std::vector<experiments::ComparedQuantity> compared = ReproduceWithProgress(options);
    if (options.output.json) fmt::print("{}\n", SummaryJson(compared).dump(2));
    if (options.output.ForPeople()) PrintSummary(compared, options.out);
    return kPassed;
  } catch (const util::Interrupted&) {
    spdlog::warn("interrupted: what is measured is kept in {}/measurements, and the same command goes on from there",
                 options.out);
    return kInterrupted;
  }
}

}  // namespace

void AddPaper(CLI::App& app, Run& run) {
  const auto options = std::make_shared<PaperOptions>();
  CLI::App& command = *app.add_subcommand(
      "paper", "Measure everything that the paper reports, and put it beside the published figures");
  command.add_option("--out", options->out, "Folder for the report; a run that was stopped goes on there")
      ->required()
      ->type_name("DIR");
  command.add_flag("--quick", options->quick, "Every section on few samples: minutes, not an hour");
  command.add_option("--jobs", options->jobs, "Measurements at a time (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return Reproduce(*options); }; });
}

}  // namespace touchdown::cli
