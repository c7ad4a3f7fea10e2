#include "scenarios/cli/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "scenarios/flight/output_file.h"
#include "scenarios/report/flight_files.h"
#include "scenarios/report/flight_page.h"
#include "scenarios/sweep/sweep_report.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

void MakeFlightReport(const fs::path& folder, const fs::path& page) {
  const FlightFiles files = ReadFlightFiles(folder);
  CheckOutputFile(page, kFlightPageMark);
  WriteOutputFile(page, FlightPage(files), kFlightPageMark);
}

void MakeSweepReport(const fs::path& folder, const fs::path& page) {
  const SweepOutcome sweep = ReadOutcome({folder, SweepStore::Access::kRead});
  CheckOutputFile(page, kSweepPageMark);
  WriteOutputFile(page, SweepPage(sweep, Summarize(sweep), folder), kSweepPageMark);
}

int MakeReport(const fs::path& folder) {
  const fs::path page = folder / "report.html";
  fs::exists(folder / "sweep.db") ? MakeSweepReport(folder, page) : MakeFlightReport(folder, page);
  fmt::print("{}\n", page.string());
  return kPassed;
}

}  // namespace

void AddReport(CLI::App& app, Run& run) {
  const auto folder = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("report", "Rebuild the report.html of a flight or a sweep from the files beside it");
  command.add_option("DIR", *folder, "The folder of the flight or the sweep")->required();
  command.callback([folder, &run] { run = [folder] { return MakeReport(*folder); }; });
}

}  // namespace touchdown::scenarios
