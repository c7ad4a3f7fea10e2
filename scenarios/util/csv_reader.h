#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::util {

/// A row of a CSV text.
struct CsvRow {
  std::vector<std::string_view> cells = {};
  int line = 0;                ///< The line of the text on which the row begins, from 1.
  bool is_terminated = false;  ///< A line end follows the row. The last row of a text that is cut off has none.
};

/// Reads the rows of a CSV text (RFC 4180): cells are separated by commas; a cell in double quotes may hold commas,
/// line ends and, doubled, quotes; a line ends with LF or CRLF.
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

  /// The next row; nullopt at the end of the text. Its cells are valid as long as the reader and its text.
  std::optional<CsvRow> Next();

 private:
  CsvRow NextRow();
  std::string_view NextCell();
  std::string_view Unquoted();
  void SkipLine();

  std::string_view rest_;
  Options options_;
  int line_ = 1;
  std::deque<std::string> unquoted_;  ///< Unescaped cells, which do not occur literally in the text.
};

}  // namespace touchdown::util
