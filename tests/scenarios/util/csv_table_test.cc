#include "scenarios/util/csv_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/throws_input_error.h"

namespace touchdown::util {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;
using tests::ThrowsInputError;

TEST(CsvTable, ReadsColumnsByName) {
  const std::string text = "t_s,phase,x_m\n0,ramp,1.5\n0.005,hover,\n";
  const CsvTable table(text, "flight.csv");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table.Texts("phase"), ElementsAre("ramp", "hover"));
  EXPECT_THAT(table.Numbers("x_m"), ElementsAre(Optional(1.5), std::nullopt));
  EXPECT_THAT(table.Times("t_s"), ElementsAre(0.0, 0.005));
}

TEST(CsvTable, MayHaveNoRows) {
  const std::string text = "t_s,x_m\n";
  const CsvTable table(text, "flight.csv");
  EXPECT_EQ(table.rows(), 0u);
  EXPECT_TRUE(table.Times("t_s").empty());
}

TEST(CsvTable, ReportsLineOfInvalidRow) {
  EXPECT_THAT([] { CsvTable("", "a.csv"); }, ThrowsInputError("a.csv:1: the line is truncated"));
  EXPECT_THAT([] { CsvTable("t_s,x_m\n0,1\n1,2.", "a.csv"); }, ThrowsInputError("a.csv:3: the line is truncated"));
  EXPECT_THAT([] { CsvTable("t_s,x_m,y_m\n0,1,2\n1,2\n", "a.csv"); },
              ThrowsInputError("a.csv:3: y_m: the row has 2 cells, but the header has 3"));
  EXPECT_THAT([] { CsvTable("t_s,x_m\n0,1,2\n", "a.csv"); },
              ThrowsInputError("a.csv:2: x_m: the row has 3 cells, but the header has 2"));
}

TEST(CsvTable, ReportsLineAndColumnOfInvalidNumber) {
  for (const std::string cell : {"one", "1.5x", "nan", "inf", " 1", "1e999"}) {
    const std::string text = "t_s,x_m\n0,1\n1," + cell + "\n";
    EXPECT_THAT([&] { CsvTable(text, "a.csv").Numbers("x_m"); },
                ThrowsInputError("a.csv:3: x_m: '" + cell + "' is not a finite number"));
  }
}

TEST(CsvTable, ReportsMissingColumnAndEmptyCell) {
  const std::string text = "t_s,x_m\n0,\n";
  const CsvTable table(text, "a.csv");
  EXPECT_THAT([&] { table.Texts("y_m"); }, ThrowsInputError("a.csv:1: y_m: no such column"));
  EXPECT_THAT([&] { table.AllNumbers("x_m"); }, ThrowsInputError("a.csv:2: x_m: is empty"));
}

TEST(CsvTable, RejectsTimesThatDoNotIncrease) {
  for (const std::string rows : {"0\n1\n1\n", "0\n2\n1\n"}) {
    const std::string text = "t_s\n" + rows;
    EXPECT_THAT([&] { CsvTable(text, "a.csv").Times("t_s"); },
                ThrowsInputError("a.csv:4: t_s: is not greater than in the previous row"));
  }
}

}  // namespace
}  // namespace touchdown::util
