#include "scenarios/util/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "models/error.h"
#include "scenarios/util/number.h"

namespace touchdown::util {

CsvTable::CsvTable(const std::string& text, std::string name)
    : name_(std::move(name)), reader_(std::make_unique<CsvReader>(text)) {
  std::optional<CsvRow> row = reader_->Next();
  if (!row || !row->is_terminated) throw InputError(fmt::format("{}:1: the line is truncated", name_));
  header_ = std::move(row->cells);
  while ((row = reader_->Next())) {
    if (!row->is_terminated) throw InputError(fmt::format("{}:{}: the line is truncated", name_, row->line));
    if (row->cells.size() != header_.size()) {
      const std::string_view at = header_[std::min(row->cells.size(), header_.size() - 1)];
      throw InputError(fmt::format("{}:{}: {}: the row has {} cells, but the header has {}", name_, row->line, at,
                                   row->cells.size(), header_.size()));
    }
    rows_.push_back(*std::move(row));
  }
}

std::vector<std::string_view> CsvTable::Texts(std::string_view column) const {
  const std::size_t index = IndexOf(column);
  std::vector<std::string_view> texts;
  texts.reserve(rows());
  for (const CsvRow& row : rows_) texts.push_back(row.cells[index]);
  return texts;
}

std::vector<std::optional<double>> CsvTable::Numbers(std::string_view column) const {
  std::vector<std::optional<double>> numbers;
  numbers.reserve(rows());
  for (const std::string_view cell : Texts(column)) {
    numbers.push_back(FiniteNumber(cell));
    if (!numbers.back() && !cell.empty()) {
      Fail(numbers.size() - 1, column, fmt::format("'{}' is not a finite number", cell));
    }
  }
  return numbers;
}

std::vector<double> CsvTable::AllNumbers(std::string_view column) const {
  std::vector<double> numbers;
  numbers.reserve(rows());
  for (const std::optional<double> number : Numbers(column)) {
    if (!number) Fail(numbers.size(), column, "is empty");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> CsvTable::Times(std::string_view column) const {
  const std::vector<double> times = AllNumbers(column);
  const auto later = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>());
  if (later != times.end()) {
    Fail(static_cast<std::size_t>(later - times.begin()) + 1, column, "is not greater than in the previous row");
  }
  return times;
}

std::size_t CsvTable::IndexOf(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) throw InputError(fmt::format("{}:1: {}: no such column", name_, column));
  return static_cast<std::size_t>(found - header_.begin());
}

void CsvTable::Fail(std::size_t row, std::string_view column, std::string_view why) const {
  throw InputError(fmt::format("{}:{}: {}: {}", name_, rows_[row].line, column, why));
}

}  // namespace touchdown::util
