#include "scenarios/cli/sweep_outcome.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>

#include "scenarios/cli/sweep_text.h"
#include "scenarios/sweeper/analysis/rows_csv.h"
#include "scenarios/sweeper/page/sweep_report.h"
#include "scenarios/util/output_file.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;

fs::path PageIn(const fs::path& folder) { return folder / "report.html"; }

void WritePage(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary, const fs::path& folder) {
  std::string page;
  try {
    page = sweeper::SweepPage(sweep, summary, folder);
  } catch (const std::exception& error) {
    spdlog::warn("report.html was not written: {}", error.what());
    return;
  }
  util::WriteOutputFile(PageIn(folder), page, sweeper::kSweepPageSignature);
}

}  // namespace

void CheckSweepFiles(const SweepFiles& files) {
  if (files.csv) util::CheckOutputFile(*files.csv, sweeper::kRowsCsvSignature);
  util::CheckOutputFile(PageIn(files.folder), sweeper::kSweepPageSignature);
}

sweeper::SweepSummary ReportOutcome(const SweepFiles& files, const OutputOptions& output) {
  const sweeper::SweepOutcome sweep = sweeper::ReadOutcome({files.folder, sweeper::SweepStore::Access::kRead});
  sweeper::SweepSummary summary = sweeper::Summarize(sweep);
  if (output.ForPeople()) fmt::print("{}", SummaryText(sweep, summary, files.folder));
  if (output.json) fmt::print("{}", SummaryJson(sweep, summary, files.folder));
  std::fflush(stdout);
  if (files.csv)
    util::WriteOutputFile(*files.csv, sweeper::RowsCsv(sweep.spec.keys(), sweep.results), sweeper::kRowsCsvSignature);
  WritePage(sweep, summary, files.folder);
  return summary;
}

}  // namespace touchdown::cli
