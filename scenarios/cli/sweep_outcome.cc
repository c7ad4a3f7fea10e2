#include "scenarios/cli/sweep_outcome.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>

#include "scenarios/cli/sweep_text.h"
#include "scenarios/flight/output_file.h"
#include "scenarios/sweep/rows_csv.h"
#include "scenarios/sweep/sweep_report.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

fs::path PageIn(const fs::path& folder) { return folder / "report.html"; }

void WritePage(const SweepOutcome& sweep, const SweepSummary& summary, const fs::path& folder) {
  std::string page;
  try {
    page = SweepPage(sweep, summary, folder);
  } catch (const std::exception& error) {
    spdlog::warn("no report: {}", error.what());
    return;
  }
  WriteOutputFile(PageIn(folder), page, kSweepPageMark);
}

}  // namespace

void CheckSweepFiles(const SweepFiles& files) {
  if (files.csv) CheckOutputFile(*files.csv, kRowsCsvMark);
  CheckOutputFile(PageIn(files.folder), kSweepPageMark);
}

SweepSummary TellOutcome(const SweepFiles& files, const Talk& talk) {
  const SweepOutcome sweep = ReadOutcome({files.folder, SweepStore::Access::kRead});
  SweepSummary summary = Summarize(sweep);
  if (talk.ForPeople()) fmt::print("{}", SummaryText(sweep, summary, files.folder));
  if (talk.json) fmt::print("{}", SummaryJson(sweep, summary, files.folder));
  std::fflush(stdout);
  if (files.csv) WriteOutputFile(*files.csv, RowsCsv(sweep.terms.keys(), sweep.results), kRowsCsvMark);
  WritePage(sweep, summary, files.folder);
  return summary;
}

}  // namespace touchdown::scenarios
