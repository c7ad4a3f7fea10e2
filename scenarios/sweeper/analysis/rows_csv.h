#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// Signature of a file of rows: see WriteOutputFile.
inline constexpr const char* kRowsCsvSignature = "id,variant,";

/// Results of a sweep, from a folder or a CSV file.
struct StoredResults {
  std::string source = {};  ///< Folder or CSV file.
  std::vector<std::string> keys = {};
  std::vector<SweepResult> results = {};
};

/// The results as CSV, sorted by id: id, variant, the parameters `keys`, seed, process, verdict, outcome, every metric
/// (empty where a flight does not have it), log_sha256. It does not depend on when, where or in which order the flights
/// were flown.
std::string RowsCsv(const std::vector<std::string>& keys, std::vector<SweepResult> results);

/// Reads text that RowsCsv wrote. Metrics unknown to this program are left out. Throws InputError, naming file and
/// line, for any other text.
StoredResults ReadRowsCsv(const std::filesystem::path& file);

}  // namespace touchdown::sweeper
