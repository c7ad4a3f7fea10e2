#include "scenarios/report/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace touchdown::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Figure Line() {
  return {.name = "line",
          .title = "A line",
          .csv = "x,y\n1,2\n2,\n3,1\n4,5\n",
          .plot = "plot data using 'x':'y' with linespoints pt 7 lc rgb ESTIMATE title 'y'\n",
          .width_cm = 10.0,
          .height_cm = 5.0};
}

TEST(Figure, DrawsSvgAndPdf) {
  const DrawnFigure drawn = Draw(Line());
  EXPECT_THAT(drawn.svg, HasSubstr("<svg"));
  EXPECT_THAT(drawn.pdf, StartsWith("%PDF-"));
}

TEST(Figure, PageSvgUsesColorVariablesAndUniqueIds) {
  const std::string svg = Draw(Line()).page_svg;
  EXPECT_THAT(svg, StartsWith("<svg"));
  EXPECT_THAT(svg, HasSubstr("var(--estimate)"));
  EXPECT_THAT(svg, HasSubstr("var(--muted)"));
  EXPECT_THAT(svg, HasSubstr("line_gpPt"));
  EXPECT_THAT(svg, Not(HasSubstr("'gpPt")));
  EXPECT_THAT(svg, Not(HasSubstr("#0072b2")));
}

TEST(Figure, DrawsEqualFilesForEqualFigures) {
  const DrawnFigure once = Draw(Line());
  std::this_thread::sleep_for(
      std::chrono::milliseconds(1100));  // Longer than the 1 s resolution of the PDF creation date.
  const DrawnFigure again = Draw(Line());
  EXPECT_EQ(once.svg, again.svg);
  EXPECT_EQ(once.pdf, again.pdf);
}

TEST(Figure, ThrowsErrorOutputOfGnuplot) {
  Figure figure = Line();
  figure.plot = "plot nonsense using\n";
  try {
    Draw(figure);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot: "));
    EXPECT_THAT(error.what(), HasSubstr("nonsense"));
  }
}

}  // namespace
}  // namespace touchdown::report
