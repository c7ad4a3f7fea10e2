#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace touchdown::util {

/// Row of a CSV file whose first column is the time in nanoseconds, as in the EuRoC data sets.
struct StampedRow {
  std::int64_t time_ns = 0;
  std::vector<std::string> cells;  ///< Cells after the time, without surrounding blanks.
  std::string place;               ///< "data.csv:12", for messages.

  /// Cell as a finite number. Throws InputError with place and column for other text.
  double Number(std::size_t cell) const;
};

/// Reads the rows of a CSV file with increasing times. Lines that begin with # are comments. Throws InputError with
/// file and line for a file that cannot be read or has no rows, a row with fewer than `min_cells` cells after the time,
/// or a time that is not an integer or does not increase.
std::vector<StampedRow> ReadStampedCsv(const std::filesystem::path& file, std::size_t min_cells);

}  // namespace touchdown::util
