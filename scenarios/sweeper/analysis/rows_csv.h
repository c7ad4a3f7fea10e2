#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// Signature of a file of rows: see WriteOutputFile.
inline constexpr const char* kRowsCsvSignature = "id,variant,";

/// The results of a sweep, wherever they were kept.
struct StoredResults {
  std::string source = {};  ///< The sweep's folder or the CSV file.
  std::vector<std::string> keys = {};
  std::vector<SweepResult> results = {};
};

/// The results as CSV, sorted by id: id, variant, the parameters `keys`, seed, process, verdict, outcome, every metric
/// (empty where a flight does not have it), log_sha256. It holds nothing
/// that depends on when, where or in which order they were flown.
std::string RowsCsv(const std::vector<std::string>& keys, std::vector<SweepResult> results);

/// What RowsCsv wrote. Metrics that this program does not know are left out. Throws InputError, naming file and line,
/// for what is no such file.
StoredResults ReadRowsCsv(const std::filesystem::path& file);

}  // namespace touchdown::sweeper
