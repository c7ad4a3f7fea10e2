#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
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
  const auto text = [](const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "-"; };
  for (const experiments::ComparedQuantity& row : compared) {
    fmt::print("{} {:<56} {:>10} {:>10} {:<4} {}\n", row.MeetsPublished() ? " " : "!", row.quantity,
               text(row.published), text(row.ours), row.unit, row.spread);
  }
  fmt::print("{} of {} exceed the published value; report in {}/report.html\n",
             std::count_if(compared.begin(), compared.end(),
                           [](const experiments::ComparedQuantity& row) { return !row.MeetsPublished(); }),
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
    rows.back()["kept"] = row.MeetsPublished();
  }
  return rows;
}

std::vector<experiments::ComparedQuantity> ReproduceWithProgress(const PaperOptions& options) {
  Progress progress(!options.output.ForPeople());
  return experiments::ReproducePaper(options.out, {.quick = options.quick, .jobs = options.jobs}, InterruptRequested,
                                     [&](double fraction, const std::string& text) {
                                       if (progress.IsDue()) progress.Update(fraction, text);
                                     });
}

int Reproduce(const PaperOptions& options) {
  try {
    const std::vector<experiments::ComparedQuantity> compared = ReproduceWithProgress(options);
    if (options.output.json) fmt::print("{}\n", SummaryJson(compared).dump(2));
    if (options.output.ForPeople()) PrintSummary(compared, options.out);
    return kPassed;
  } catch (const util::Interrupted&) {
    spdlog::warn(
        "interrupted: the measurements so far are kept in {}/measurements; the same command resumes from there",
        options.out);
    return kInterrupted;
  }
}

}  // namespace

void AddPaper(CLI::App& app, Run& run) {
  const auto options = std::make_shared<PaperOptions>();
  CLI::App& command = *app.add_subcommand(
      "paper", "Measure all quantities that the paper reports, and compare them with the published values");
  command.add_option("--out", options->out, "Output directory; an interrupted run resumes there")
      ->required()
      ->type_name("DIR");
  command.add_flag("--quick", options->quick, "Measure every section on few samples, in minutes instead of an hour");
  command
      .add_option("--jobs", options->jobs, "Maximum number of concurrent measurements (default: the number of cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return Reproduce(*options); }; });
}

}  // namespace touchdown::cli
