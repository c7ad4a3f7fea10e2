#include "scenarios/util/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/util/csv_writer.h"

namespace touchdown::util {
namespace {

using ::testing::ElementsAre;

TEST(CsvReader, ReadsQuotedCells) {
  const std::string text = "a,\"b,\"\"c\"\"\nd\",\"\"\ne,f,g\n";
  CsvReader reader(text);
  const auto first = reader.Next(), second = reader.Next();
  EXPECT_THAT(first.value().cells, ElementsAre("a", "b,\"c\"\nd", ""));
  EXPECT_THAT(second.value().cells, ElementsAre("e", "f", "g"));
  EXPECT_EQ(first->line, 1);
  EXPECT_EQ(second->line, 3);
  EXPECT_FALSE(reader.Next());
}

TEST(CsvReader, AcceptsLfAndCrlf) {
  const std::string text = "a,b\r\n\"c\",\r\n\nd";
  CsvReader reader(text);
  EXPECT_THAT(reader.Next()->cells, ElementsAre("a", "b"));
  EXPECT_THAT(reader.Next()->cells, ElementsAre("c", ""));
  EXPECT_THAT(reader.Next()->cells, ElementsAre(""));
  const auto last = reader.Next();
  EXPECT_THAT(last.value().cells, ElementsAre("d"));
  EXPECT_FALSE(last->is_terminated);
}

TEST(CsvReader, ReportsUnterminatedQuotedCell) {
  const std::string text = "a,\"b\n";
  CsvReader reader(text);
  const auto row = reader.Next();
  EXPECT_THAT(row.value().cells, ElementsAre("a", "b\n"));
  EXPECT_FALSE(row->is_terminated);
}

TEST(CsvReader, SkipsCommentsAndBlanksOnRequest) {
  const std::string text = "# \"a\n\n 1 ,\t2\r\n#";
  CsvReader reader(text, {.skips_comments = true, .trims = true});
  const auto row = reader.Next();
  EXPECT_THAT(row.value().cells, ElementsAre("1", "2"));
  EXPECT_EQ(row->line, 3);
  EXPECT_FALSE(reader.Next());
}

TEST(CsvReader, ReadsOutputOfCsvWriter) {
  const std::vector<std::string> cells{"", "plain", "a,b", "\"", "two\nlines", "\r\n", "\"\"", " x "};
  const std::string text = CsvLine(cells);
  CsvReader reader(text);
  const auto row = reader.Next();
  EXPECT_THAT(row.value().cells, ::testing::ElementsAreArray(cells));
  EXPECT_TRUE(row->is_terminated);
  EXPECT_FALSE(reader.Next());
}

TEST(CsvWriter, PassesSameTextToSink) {
  const auto fill = [](CsvWriter& table) {
    for (int i = 0; i < 20000; ++i) {
      table << i << 0.5 << "hover";
      table.EndLine();
    }
  };
  CsvWriter kept("a,b,c");
  fill(kept);
  std::string text;
  int pieces = 0;
  CsvWriter streamed("a,b,c", [&](std::string_view piece) {
    text += piece;
    ++pieces;
  });
  fill(streamed);
  EXPECT_EQ(streamed.Take(), "");
  EXPECT_EQ(text, kept.Take());
  EXPECT_GT(pieces, 2);
}

}  // namespace
}  // namespace touchdown::util
