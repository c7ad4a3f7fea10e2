#include "scenarios/sweeper/run/fly_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "models/error.h"
#include "scenarios/report/contact_sheet.h"
#include "scenarios/runner/fly.h"
#include "scenarios/sweeper/run/failure_phase.h"
#include "scenarios/util/file.h"
#include "scenarios/util/output_file.h"
#include "scenarios/util/platform.h"
#include "scenarios/util/program_digest.h"
#include "scenarios/util/stopwatch.h"
#include "scenarios/util/version.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRowSignature = "\"failed_phase\"";
constexpr const char* kPngSignature = "PNG";

/// Creates a folder. Throws InputError if it cannot be created.
void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
}

/// Copies the result of a flight, and the check that failed first, into a row.
void SetResult(const runner::Scenario& scenario, const runner::FlightLog& log, FlightRow& row) {
  const runner::FlightResult result = runner::JudgeFlight(scenario, log);
  row.process = ProcessEnd::kFlown;
  row.verdict = result.verdict;
  row.outcome = result.outcome;
  row.reason = result.reason;
  row.metrics = result.metrics;
  row.log_sha256 = result.log_sha256;
  const auto failed =
      std::find_if(result.checks.begin(), result.checks.end(), [](const runner::Check& check) { return !check.pass; });
  if (failed == result.checks.end()) return;
  row.failed_check = failed->name;
  row.failed_phase = FailurePhase(*failed, log);
}

}  // namespace

std::optional<FlightRow> ReadRow(const fs::path& file) {
  const std::optional<std::string> text = util::ReadTextFileIfPresent(file);
  return text ? RowFromJson(*text) : std::nullopt;
}

std::optional<FlightRow> ReadRowOrSetAside(const fs::path& file) {
  std::optional<FlightRow> row = ReadRow(file);
  if (row || !fs::exists(file)) return row;
  std::error_code error;
  fs::rename(file, fs::path(file).replace_extension(".damaged"), error);
  if (error) throw InputError(fmt::format("{}: not a complete row, and cannot be renamed to .damaged", file.string()));
  return std::nullopt;
}

RowFolder::RowFolder(const fs::path& folder) : rows_(folder / "rows"), images_(folder / "pictures") {
  MakeFolder(rows_);
  MakeFolder(images_);
}

void RowFolder::Write(const FlightRow& row) const {
  util::WriteOutputFile(RowFile(row.id), RowJson(row), kRowSignature);
}

void FlyRow(const std::string& scenario_yaml, const std::string& id, const RowFolder& folder) {
  const runner::Scenario scenario = runner::ParseScenario(scenario_yaml, "scenario", {});
  FlightRow row{.id = id,
                .program = util::ProgramDigest(),
                .version = std::string(util::Version()),
                .host = util::HostName(),
                .scenario = scenario_yaml};
  const util::Stopwatch stopwatch;
  report::ContactSheet sheet(scenario.assumed_camera(), scenario.time);
  runner::FlightObserver* const observers[] = {&sheet};
  try {
    SetResult(scenario, runner::FlyClosedLoop(scenario, observers, nullptr), row);
  } catch (const InputError& error) {
    row.process = ProcessEnd::kFlown;
    row.reason = error.what();
  }
  row.wall_s = stopwatch.seconds();
  if (row.process == ProcessEnd::kFlown && !row.passed()) {
    if (const auto png = sheet.Png()) util::WriteOutputFile(folder.ImageFile(row.id), *png, kPngSignature);
  }
  folder.Write(row);
}

}  // namespace touchdown::sweeper
