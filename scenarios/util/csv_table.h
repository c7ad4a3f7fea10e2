#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/util/csv_reader.h"

namespace touchdown::util {

/// CSV text with a header, read by column.
///
/// Every member throws InputError with file, line and column for a missing column or an invalid cell.
class CsvTable {
 public:
  /// `name` is the file name in messages; `text` must outlive the table. Throws InputError if the
  /// number of cells of a row differs from that of the header, or if the last line has no end (truncated file).
  CsvTable(const std::string& text, std::string name);

  std::size_t rows() const { return rows_.size(); }
  const std::vector<std::string_view>& header() const { return header_; }

  /// Cells of a column. The views are valid during the lifetime of table and text.
  std::vector<std::string_view> Texts(std::string_view column) const;

  /// Cells of a column as finite numbers; nullopt for an empty cell.
  std::vector<std::optional<double>> Numbers(std::string_view column) const;

  /// Cells of a column as finite numbers. An empty cell is an error.
  std::vector<double> AllNumbers(std::string_view column) const;

  /// Cells of a column as strictly increasing finite numbers.
  std::vector<double> Times(std::string_view column) const;

 private:
  std::size_t IndexOf(std::string_view column) const;
  [[noreturn]] void Fail(std::size_t row, std::string_view column, std::string_view why) const;

  std::string name_;
  std::unique_ptr<CsvReader> reader_;  ///< Owns the cells that are quoted in the text.
  std::vector<std::string_view> header_;
  std::vector<CsvRow> rows_;
};

}  // namespace touchdown::util
