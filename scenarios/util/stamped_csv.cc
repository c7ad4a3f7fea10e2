#include "scenarios/util/stamped_csv.h"

#include <fmt/format.h>

#include "models/error.h"
#include "scenarios/util/csv_reader.h"
#include "scenarios/util/file.h"
#include "scenarios/util/number.h"

namespace touchdown::util {

double StampedRow::Number(std::size_t cell) const {
  const std::optional<double> value = FiniteNumber(cells[cell]);
  if (!value) throw InputError(fmt::format("{}: column {}: '{}' is not a finite number", place, cell + 2, cells[cell]));
  return *value;
}

std::vector<StampedRow> ReadStampedCsv(const std::filesystem::path& file, std::size_t min_cells) {
  const std::string text = ReadTextFile(file);
  CsvReader reader(text, {.skips_comments = true, .trims = true});
  std::vector<StampedRow> rows;
  while (const std::optional<CsvRow> row = reader.Next()) {
    const std::string place = fmt::format("{}:{}", file.string(), row->line);
    if (row->cells.size() < min_cells + 1) {
      throw InputError(
          fmt::format("{}: has {} columns; required: at least {}", place, row->cells.size(), min_cells + 1));
    }
    const auto time_ns = FiniteNumber<std::int64_t>(row->cells.front());
    if (!time_ns) throw InputError(fmt::format("{}: '{}' is not a time in nanoseconds", place, row->cells.front()));
    if (!rows.empty() && *time_ns <= rows.back().time_ns) {
      throw InputError(fmt::format("{}: the time is not after that of the previous row", place));
    }
    rows.push_back({.time_ns = *time_ns, .cells = {row->cells.begin() + 1, row->cells.end()}, .place = place});
  }
  if (rows.empty()) throw InputError(fmt::format("{}: has no rows", file.string()));
  return rows;
}

}  // namespace touchdown::util
