#include "scenarios/util/stamped_csv.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "models/error.h"

namespace touchdown::util {
namespace {

std::string Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

std::vector<std::string> TrimmedCells(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(Trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

template <typename T>
bool Parse(const std::string& text, T& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

}  // namespace

double StampedRow::Number(std::size_t cell) const {
  double value = 0.0;
  if (!Parse(cells[cell], value) || !std::isfinite(value)) {
    throw InputError(fmt::format("{}: column {}: '{}' is no number", place, cell + 2, cells[cell]));
  }
  return value;
}

std::vector<StampedRow> ReadStampedCsv(const std::filesystem::path& file, std::size_t least_cells) {
  std::ifstream stream(file);
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::vector<StampedRow> rows;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (Trimmed(line).empty() || line.starts_with('#')) continue;
    StampedRow row{.time_ns = 0, .cells = TrimmedCells(line), .place = fmt::format("{}:{}", file.string(), number)};
    if (row.cells.size() < least_cells + 1) {
      throw InputError(fmt::format("{}: has {} columns instead of {}", row.place, row.cells.size(), least_cells + 1));
    }
    if (!Parse(row.cells.front(), row.time_ns)) {
      throw InputError(fmt::format("{}: '{}' is no time in nanoseconds", row.place, row.cells.front()));
    }
    row.cells.erase(row.cells.begin());
    if (!rows.empty() && row.time_ns <= rows.back().time_ns) {
      throw InputError(fmt::format("{}: its time does not come after the one before", row.place));
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) throw InputError(fmt::format("{}: has no rows", file.string()));
  return rows;
}

}  // namespace touchdown::util
