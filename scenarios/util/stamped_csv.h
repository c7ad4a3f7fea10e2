#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace touchdown::util {

/// A row of a file in which every row begins with a time in nanoseconds, as in the EuRoC data sets.
struct StampedRow {
  std::int64_t time_ns = 0;
  std::vector<std::string> cells;  ///< The other cells, without surrounding blanks.
  std::string place;               ///< "data.csv:12", for messages.

  /// The cell as a number. Throws InputError, naming place and column, unless it is a finite one.
  double Number(std::size_t cell) const;
};

/// Reads the rows of a file with increasing times; lines that begin with # are comments. Throws InputError, naming file
/// and line, for a file that cannot be read or has no rows, a row with fewer cells than `least_cells` beside its time,
/// or a time that is not an integer or does not increase.
std::vector<StampedRow> ReadStampedCsv(const std::filesystem::path& file, std::size_t least_cells);

}  // namespace touchdown::util
