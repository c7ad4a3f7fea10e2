#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "scenarios/cli/commands.h"
#include "scenarios/report/flight_files.h"
#include "scenarios/report/flight_page.h"
#include "scenarios/sweeper/page/sweep_report.h"
#include "scenarios/util/output_file.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;

void WriteFlightReport(const fs::path& folder, const fs::path& page) {
  const report::FlightFiles files = report::ReadFlightFiles(folder);
  util::CheckOutputFile(page, report::kFlightPageSignature);
  util::WriteOutputFile(page, report::FlightPage(files), report::kFlightPageSignature);
}

void WriteSweepReport(const fs::path& folder, const fs::path& page) {
  const sweeper::SweepOutcome sweep = sweeper::ReadOutcome({folder, sweeper::SweepStore::Access::kRead});
  util::CheckOutputFile(page, sweeper::kSweepPageSignature);
  util::WriteOutputFile(page, sweeper::SweepPage(sweep, sweeper::Summarize(sweep), folder),
                        sweeper::kSweepPageSignature);
}

int WriteReport(const fs::path& folder) {
  const fs::path page = folder / "report.html";
  fs::exists(folder / "sweep.db") ? WriteSweepReport(folder, page) : WriteFlightReport(folder, page);
  fmt::print("{}\n", page.string());
  return kPassed;
}

}  // namespace

void AddReport(CLI::App& app, Run& run) {
  const auto folder = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("report", "Rebuild report.html of a flight or a sweep from the other files in its directory");
  command.add_option("DIR", *folder, "Output directory of the flight or the sweep")->required();
  command.callback([folder, &run] { run = [folder] { return WriteReport(*folder); }; });
}

}  // namespace touchdown::cli
