#include "scenarios/util/csv_reader.h"

#include <algorithm>

namespace touchdown::util {
namespace {

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

}  // namespace

std::optional<CsvRow> CsvReader::Next() {
  while (!rest_.empty()) {
    if (options_.skips_comments && rest_.front() == '#') {
      SkipLine();
      continue;
    }
    CsvRow row = NextRow();
    if (options_.trims) {
      for (std::string_view& cell : row.cells) cell = Trimmed(cell);
      if (row.cells.size() == 1 && row.cells.front().empty()) continue;
    }
    return row;
  }
  return std::nullopt;
}

CsvRow CsvReader::NextRow() {
  CsvRow row{.line = line_};
  while (true) {
    row.cells.push_back(NextCell());
    if (rest_.empty()) return row;
    const char separator = rest_.front();
    rest_.remove_prefix(1);
    if (separator == ',') continue;
    ++line_;
    row.is_terminated = true;
    return row;
  }
}

std::string_view CsvReader::NextCell() {
  if (rest_.starts_with('"')) return Unquoted();
  std::string_view cell = rest_.substr(0, rest_.find_first_of(",\n"));
  rest_.remove_prefix(cell.size());
  if (cell.ends_with('\r') && rest_.starts_with('\n')) cell.remove_suffix(1);
  return cell;
}

std::string_view CsvReader::Unquoted() {
  std::string& cell = unquoted_.emplace_back();
  do {
    const std::size_t end = std::min(rest_.find('"', 1), rest_.size());
    cell += rest_.substr(1, end - 1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (rest_.starts_with('"')) cell += '"';
  } while (rest_.starts_with('"'));
  line_ += static_cast<int>(std::count(cell.begin(), cell.end(), '\n'));
  return cell += NextCell();  // Empty if the text is well-formed.
}

void CsvReader::SkipLine() {
  rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size() - 1) + 1);
  ++line_;
}

}  // namespace touchdown::util
