#include "scenarios/cli/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "scenarios/flight/output_file.h"
#include "scenarios/report/flight_files.h"
#include "scenarios/report/flight_page.h"

namespace touchdown::scenarios {
namespace {

int MakeReport(const std::filesystem::path& folder) {
  const std::filesystem::path page = folder / "report.html";
  const FlightFiles files = ReadFlightFiles(folder);
  CheckOutputFile(page, kFlightPageMark);
  WriteOutputFile(page, FlightPage(files), kFlightPageMark);
  fmt::print("{}\n", page.string());
  return kPassed;
}

}  // namespace

void AddReport(CLI::App& app, Run& run) {
  const auto folder = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("report", "Rebuild a flight's report.html from the files beside it");
  command.add_option("DIR", *folder, "The flight's folder")->required();
  command.callback([folder, &run] { run = [folder] { return MakeReport(*folder); }; });
}

}  // namespace touchdown::scenarios
