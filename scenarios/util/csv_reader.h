#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::util {

/// Row of a CSV text.
struct CsvRow {
  std::vector<std::string_view> cells = {};
  int line = 0;                ///< Number of the line on which the row begins, from 1.
  bool is_terminated = false;  ///< A line end follows the row. It is missing if the text is truncated.
};

/// Reads the rows of a CSV text (RFC 4180): cells are separated by commas; a cell in double quotes may contain
/// commas, line ends and doubled quotes; a line ends with LF or CRLF.
class CsvReader {
 public:
  struct Options {
    bool skips_comments = false;  ///< Skip lines that begin with '#'.
    bool trims = false;           ///< Remove blanks around cells, and skip blank lines.
  };

  /// `text` must outlive the reader.
  explicit CsvReader(std::string_view text) : CsvReader(text, Options()) {}
  CsvReader(std::string_view text, Options options) : rest_(text), options_(options) {}
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Returns the next row; nullopt at the end of the text. The cells are valid during the lifetime of reader and text.
  std::optional<CsvRow> Next();

 private:
  CsvRow NextRow();
  std::string_view NextCell();
  std::string_view Unquoted();
  void SkipLine();

  std::string_view rest_;
  Options options_;
  int line_ = 1;
  std::deque<std::string> unquoted_;  ///< Cells without their quotes.
};

}  // namespace touchdown::util
