#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// Signature of a CSV file of rows; see WriteOutputFile.
inline constexpr const char* kRowsCsvSignature = "id,variant,";

/// Results of a sweep, loaded from an output directory or a CSV file.
struct StoredResults {
  std::string source = {};             ///< Output directory or CSV file, for messages.
  std::vector<std::string> keys = {};  ///< Keys of the parameters.
  std::vector<SweepResult> results = {};
};

/// Results as CSV, sorted by id, with the columns id, variant, parameters `keys`, seed, process, verdict, outcome, all
/// metrics (empty if a flight does not have one), log_sha256. It does not depend on time, machine or order of the
/// flights.
std::string RowsCsv(const std::vector<std::string>& keys, std::vector<SweepResult> results);

/// Reads a file with the output of RowsCsv. Metrics unknown to this program are ignored. Throws InputError, naming file
/// and line, for other text.
StoredResults ReadRowsCsv(const std::filesystem::path& file);

}  // namespace touchdown::sweeper
