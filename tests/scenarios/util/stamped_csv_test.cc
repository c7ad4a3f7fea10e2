#include "scenarios/util/stamped_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::util {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::ThrowsInputError;

class StampedCsvTest : public ::testing::Test {
 protected:
  std::vector<StampedRow> Read(const std::string& text, std::size_t cells = 1) const {
    return ReadStampedCsv(folder_.Put("data.csv", text), cells);
  }
  tests::TemporaryFolder folder_;
};

TEST_F(StampedCsvTest, ReadsTimesAndCellsAndSkipsComments) {
  const auto rows = Read("#timestamp [ns],filename\r\n-5,a.png\r\n\n1403636579763555584, b.png ,3\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].time_ns, -5);
  EXPECT_THAT(rows[0].cells, ElementsAre("a.png"));
  EXPECT_EQ(rows[1].time_ns, 1403636579763555584);
  EXPECT_THAT(rows[1].cells, ElementsAre("b.png", "3"));
  EXPECT_EQ(rows[1].Number(1), 3.0);
}

TEST_F(StampedCsvTest, ReportsFileAndLineOfErrors) {
  EXPECT_THAT([&] { Read("1,2\n2\n"); },
              ThrowsInputError(HasSubstr("data.csv:2: has 1 columns; required: at least 2")));
  EXPECT_THAT([&] { Read("1,2\n1.5,2\n"); },
              ThrowsInputError(HasSubstr("data.csv:2: '1.5' is not a time in nanoseconds")));
  EXPECT_THAT([&] { Read("2,2\n2,2\n"); }, ThrowsInputError(HasSubstr("data.csv:2: the time is not after")));
  EXPECT_THAT([&] { Read("# nothing\n"); }, ThrowsInputError(HasSubstr("data.csv: has no rows")));
  EXPECT_THAT([&] { ReadStampedCsv(folder_ / "none.csv", 1); },
              ThrowsInputError(HasSubstr("none.csv: cannot be read")));
  EXPECT_THAT([&] { Read("1,2,x\n", 2)[0].Number(1); },
              ThrowsInputError(HasSubstr("data.csv:1: column 3: 'x' is not a finite number")));
  EXPECT_THAT([&] { Read("1,nan\n")[0].Number(0); },
              ThrowsInputError(HasSubstr("column 2: 'nan' is not a finite number")));
}

}  // namespace
}  // namespace touchdown::util
