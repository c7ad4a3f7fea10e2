#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::util {

/// One of a flight's tables as it lies in its file: a header and rows of as many cells, commas between them.
///
/// Everything that is not as it should be throws InputError with file, line and column's name, when it is asked for.
class CsvTable {
 public:
  /// `name` stands for the file in messages. Throws InputError when a row has not the header's number of cells, as when
  /// the file was cut off.
  CsvTable(const std::string& text, std::string name);

  std::size_t rows() const { return rows_.size(); }

  /// A column's cells. The views are into the text that the table was made of.
  std::vector<std::string_view> Texts(std::string_view column) const;

  /// The same as numbers; nullopt for an empty cell.
  std::vector<std::optional<double>> Numbers(std::string_view column) const;

  /// The same of a column that has no empty cell.
  std::vector<double> AllNumbers(std::string_view column) const;

  /// The same of times, each after the one before.
  std::vector<double> Times(std::string_view column) const;

 private:
  using Cells = std::vector<std::string_view>;

  std::size_t IndexOf(std::string_view column) const;
  [[noreturn]] void Complain(std::size_t row, std::string_view column, std::string_view what) const;

  std::string name_;
  Cells header_;
  std::vector<Cells> rows_;
};

}  // namespace touchdown::util
