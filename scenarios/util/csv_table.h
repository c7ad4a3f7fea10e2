#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/util/csv_reader.h"

namespace touchdown::util {

/// A CSV text with a header, read by column.
///
/// Every member throws InputError, naming file, line and column, for a missing column or an invalid cell.
class CsvTable {
 public:
  /// `name` is the file name in messages; `text` must outlive the table. Throws InputError when a row does not have
  /// as many cells as the header, or the last line has no end, as when the file was cut off.
  CsvTable(const std::string& text, std::string name);

  std::size_t rows() const { return rows_.size(); }
  const std::vector<std::string_view>& header() const { return header_; }

  /// The cells of a column. The views are valid as long as the table and its text.
  std::vector<std::string_view> Texts(std::string_view column) const;

  /// The cells of a column as finite numbers; nullopt for an empty cell.
  std::vector<std::optional<double>> Numbers(std::string_view column) const;

  /// The cells of a column as finite numbers. No cell may be empty.
  std::vector<double> AllNumbers(std::string_view column) const;

  /// The cells of a column as numbers, each larger than the one before.
  std::vector<double> Times(std::string_view column) const;

 private:
  std::size_t IndexOf(std::string_view column) const;
  [[noreturn]] void Refuse(std::size_t row, std::string_view column, std::string_view why) const;

  std::string name_;
  std::unique_ptr<CsvReader> reader_;  ///< Owns the cells that were quoted.
  std::vector<std::string_view> header_;
  std::vector<CsvRow> rows_;
};

}  // namespace touchdown::util
