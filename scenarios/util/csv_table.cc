#include "scenarios/util/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "models/error.h"

namespace touchdown::util {
namespace {

constexpr std::size_t kHeaderLine = 1;

std::vector<std::string_view> Split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    cells.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(line);
  return cells;
}

std::optional<double> FiniteNumber(std::string_view cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool is_whole_cell = error == std::errc() && end == cell.data() + cell.size();
  return is_whole_cell && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

CsvTable::CsvTable(const std::string& text, std::string name) : name_(std::move(name)) {
  std::string_view rest = text;
  for (std::size_t line = kHeaderLine; !rest.empty() || line == kHeaderLine; ++line) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) throw InputError(fmt::format("{}:{}: is cut off", name_, line));
    Cells cells = Split(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (line == kHeaderLine) {
      header_ = std::move(cells);
    } else if (cells.size() != header_.size()) {
      const std::string_view at = header_[std::min(cells.size(), header_.size() - 1)];
      throw InputError(
          fmt::format("{}:{}: {}: the row has {} cells, the header {}", name_, line, at, cells.size(), header_.size()));
    } else {
      rows_.push_back(std::move(cells));
    }
  }
}

std::vector<std::string_view> CsvTable::Texts(std::string_view column) const {
  const std::size_t index = IndexOf(column);
  std::vector<std::string_view> texts;
  texts.reserve(rows());
  for (const Cells& row : rows_) texts.push_back(row[index]);
  return texts;
}

std::vector<std::optional<double>> CsvTable::Numbers(std::string_view column) const {
  std::vector<std::optional<double>> numbers;
  numbers.reserve(rows());
  for (const std::string_view cell : Texts(column)) {
    numbers.push_back(FiniteNumber(cell));
    if (!numbers.back() && !cell.empty()) {
      Complain(numbers.size() - 1, column, fmt::format("'{}' is no finite number", cell));
    }
  }
  return numbers;
}

std::vector<double> CsvTable::AllNumbers(std::string_view column) const {
  std::vector<double> numbers;
  numbers.reserve(rows());
  for (const std::optional<double> number : Numbers(column)) {
    if (!number) Complain(numbers.size(), column, "is empty");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> CsvTable::Times(std::string_view column) const {
  const std::vector<double> times = AllNumbers(column);
  const auto later = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>());
  if (later != times.end()) {
    Complain(static_cast<std::size_t>(later - times.begin()) + 1, column, "is not after the row before");
  }
  return times;
}

std::size_t CsvTable::IndexOf(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) throw InputError(fmt::format("{}:{}: {}: no such column", name_, kHeaderLine, column));
  return static_cast<std::size_t>(found - header_.begin());
}

void CsvTable::Complain(std::size_t row, std::string_view column, std::string_view what) const {
  throw InputError(fmt::format("{}:{}: {}: {}", name_, kHeaderLine + 1 + row, column, what));
}

}  // namespace touchdown::util
