#include "scenarios/sweeper/page/sweep_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/sweeper/page/metric_figures.h"
#include "scenarios/sweeper/page/pass_rate_figures.h"
#include "scenarios/sweeper/page/sweep_sections.h"
#include "tests/support/synthetic_sweep.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

using testing::_;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const report::ReportSection& Section(const std::vector<report::ReportSection>& sections, const std::string& id) {
  return *std::find_if(sections.begin(), sections.end(),
                       [&](const report::ReportSection& each) { return each.id == id; });
}

std::vector<std::string> RowOf(const report::ReportTable& table, const std::string& first,
                               const std::string& second = "") {
  for (const auto& row : table.rows) {
    if (row[0] == first && (second.empty() || row[1] == second)) return row;
  }
  return {};
}

class SweepReportTest : public testing::Test {
 protected:
  std::string Page() const { return SweepPage(sweep_, Summarize(sweep_), folder_.path()); }
  std::vector<report::ReportSection> Sections() const { return SweepSections(sweep_, Summarize(sweep_)); }
  report::ReportTable Table(const std::string& section) const { return Section(Sections(), section).tables.at(0); }

  const tests::TemporaryFolder folder_;
  SweepOutcome sweep_ = tests::SyntheticSweep();
};

TEST_F(SweepReportTest, ReportsPassRatesWithIntervals) {
  // Wilson intervals of 75 and 60 % for 5 seeds.
  EXPECT_THAT(RowOf(Table("pass-rate"), "all"), ElementsAre("all", "", "75.0", "33.6–94.7", "15", "20", "5"));
  EXPECT_THAT(RowOf(Table("pass-rate"), "camera.noise_sigma", "10"),
              ElementsAre("camera.noise_sigma", "10", "60.0", "23.1–88.2", "6", "10", "5"));
  EXPECT_THAT(RowOf(Table("pass-rate"), "start.yaw_deg"), testing::IsEmpty()) << "drawn values have no rows";
}

TEST_F(SweepReportTest, ReportsQuantilesOfAvailableMetrics) {
  // Values of 1, 2 ... 19 mm; the twentieth flight has none.
  EXPECT_THAT(RowOf(Table("metrics"), "flight.touchdown_xy_error_m"),
              ElementsAre("flight.touchdown_xy_error_m", "m", "19", "0.0019", "0.0055", "0.01", "0.0145", "0.0181"));
  EXPECT_THAT(RowOf(Table("metrics"), "flight.sim_time_s"), testing::IsEmpty());
}

TEST_F(SweepReportTest, JudgesTheCriteria) {
  EXPECT_THAT(Table("criteria").rows[0],
              ElementsAre("pass_rate", "0.75", "0.336–0.9468", "", "≥ 0.9", "not yet judged"))
      << "flights are missing";
  EXPECT_THAT(Page(), AllOf(HasSubstr("3 of 23 flights have not been"), Not(HasSubstr("Criteria not met"))));
  sweep_.planned = sweep_.total = 20;
  const report::ReportTable table = Table("criteria");
  EXPECT_EQ(table.rows[0].back(), "✗ no");
  EXPECT_THAT(table.rows[1], ElementsAre("flight.touchdown_xy_error_m at 0.5", "0.01", "?–?", "m", "≤ 0.05", "✓ yes"));
  EXPECT_THAT(Page(), HasSubstr("Criteria not met"));
}

TEST_F(SweepReportTest, ComparesTheFirstVariantWithTheOthers) {
  sweep_.spec.variants = {"old", "new", "none yet"};
  for (std::size_t i = 0; i < sweep_.results.size(); ++i) {
    SweepResult& result = sweep_.results[i];
    result.seed = i / 2;
    result.values = {"2", "4", "0"};
    result.variant = i % 2 == 0 ? "old" : "new";
  }
  // The touchdown error of flight n is n mm. The new variant has the flights with even n, and its last one has no
  // error.
  const report::ReportSection variants = Section(Sections(), "variants");
  ASSERT_EQ(variants.tables.size(), 1u);
  EXPECT_THAT(
      RowOf(variants.tables[0], "flight.touchdown_xy_error_m"),
      ElementsAre("flight.touchdown_xy_error_m", "m", "9", "9", "0.009", "0.01", "+0.001", "+0.001 … +0.001", _));
}

TEST_F(SweepReportTest, SortsCausesByFrequency) {
  const report::ReportTable table = Table("causes");
  EXPECT_THAT(table.rows[0], ElementsAre("gave up in blind descent", "4", "20.0"));
  EXPECT_THAT(table.rows[1], ElementsAre("out of memory", "1", "5.0"));
}

TEST_F(SweepReportTest, CountsFlightsInEachCellOfTheHeatMap) {
  // Sorted as numbers: column 0 is the noise 2, column 1 the noise 10.
  EXPECT_EQ(HeatMapFigure(sweep_, 0, 1, "").csv,
            "x,y,passed,flown,percent\n0,0,5,5,100.00\n1,0,5,5,100.00\n0,1,4,5,80.00\n1,1,1,5,20.00\n");
}

TEST_F(SweepReportTest, SortsPassRatesByValue) {
  const report::ReportSection section = Section(Sections(), "pass-rate");
  EXPECT_EQ(section.figures[0].csv,
            "curve,variant,place,value,percent,low,high\n0,,2,2,90.00,46.29,98.95\n0,,10,10,60.00,23.07,88.24\n");
}

TEST_F(SweepReportTest, PlotsEachVariantSeparately) {
  sweep_.spec.variants = {"old", "new"};
  for (std::size_t i = 0; i < sweep_.results.size(); ++i) sweep_.results[i].variant = i < 12 ? "old" : "new";
  const report::ReportSection section = Section(Sections(), "pass-rate");
  EXPECT_THAT(section.figures[0].csv,
              AllOf(HasSubstr("\n0,old,1.968,2,100.00,"), HasSubstr("\n1,new,10.032,10,50.00,")));
  EXPECT_THAT(section.figures[0].plot, AllOf(HasSubstr("title 'old'"), HasSubstr("title 'new'")));
  EXPECT_EQ(HeatMapFigure(sweep_, 0, 1, "new").csv,
            "x,y,passed,flown,percent\n0,0,2,2,100.00\n1,0,2,2,100.00\n0,1,1,2,50.00\n1,1,0,2,0.00\n");
}

TEST_F(SweepReportTest, ReportsTheBoundaryAtTheTopOfThePage) {
  sweep_.spec.axes[0] = {"camera.noise_sigma", {}};
  sweep_.spec.search = {"camera.noise_sigma", 2.0, 10.0, 0.5};
  EXPECT_THAT(Page(), AllOf(HasSubstr("<dt>Boundary</dt>"), Not(HasSubstr("95 % interval (Wilson)</dt>"))));
  for (SweepResult& result : sweep_.results) result.row.verdict = runner::Verdict::kPass;
  EXPECT_THAT(Page(), HasSubstr("<dt>No boundary found</dt>"));
}

TEST_F(SweepReportTest, CountsEachFlightOfAHistogramOnce) {
  // 19 values in 5 bins of 3.6 mm from 1 mm: 1-4, 5-8, 9-11, 12-15 and 16-19; flights 6, 10, 14 and 18 failed.
  const std::string csv = HistogramFigure(sweep_, "flight.touchdown_xy_error_m").csv;
  EXPECT_EQ(csv,
            "from,to,passed,all\n0.001,0.0046,4,4\n0.0046,0.0082,3,4\n0.0082,0.0118,2,3\n0.0118,0.0154,3,4\n"
            "0.0154,0.019,3,4\n");
}

TEST_F(SweepReportTest, PlotsTouchdownsAroundThePad) {
  const report::Figure figure = Section(Sections(), "touchdown").figures.at(0);
  EXPECT_THAT(figure.csv, StartsWith("x_mm,passed_y_mm,failed_y_mm\n1.000,-1.000,\n2.000,-1.000,\n"));
  EXPECT_THAT(figure.csv, HasSubstr("\n6.000,,-1.000\n"));
  EXPECT_THAT(figure.plot, HasSubstr("using (80*cos(t)):(80*sin(t))"));
  EXPECT_THAT(figure.caption, HasSubstr("for the 19 flights"));
}

TEST_F(SweepReportTest, ListsFailuresWithCommandAndImage) {
  folder_.Put("pictures/id6.png", "an image");
  const std::string page = Page();
  const std::string command = "touchdown fly --from " + folder_.path().string() + " ";
  for (const char* id : {"id6", "id10", "id14", "id18", "id20"}) EXPECT_THAT(page, HasSubstr(command + id + "<"));
  EXPECT_THAT(page, Not(HasSubstr(command + "id2<"))) << "passed";
  EXPECT_THAT(page, HasSubstr("src=\"pictures/id6.png\""));
  EXPECT_THAT(page, Not(HasSubstr("pictures/id10.png"))) << "there is no such file";
  EXPECT_THAT(page, HasSubstr("<b>gave up in blind descent</b><br>the pad was &lt;lost&gt;"));
  EXPECT_THAT(page, HasSubstr("std::bad_alloc &lt;/pre&gt;"));
}

TEST_F(SweepReportTest, ShowsFiftyImagesAndLinksTheOthers) {
  for (SweepResult& result : sweep_.results) result.row.verdict = runner::Verdict::kFail;
  const std::vector<SweepResult> twenty = sweep_.results;
  for (int i = 1; i < 3; ++i) sweep_.results.insert(sweep_.results.end(), twenty.begin(), twenty.end());
  for (int i = 1; i <= 20; ++i) folder_.Put("pictures/id" + std::to_string(i) + ".png", "an image");
  const std::string page = Page();
  const auto count = [&page](const std::string& text) {
    int found = 0;
    for (std::size_t at = 0; (at = page.find(text, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("<img loading=\"lazy\""), 50);
  EXPECT_EQ(count("<a href=\"pictures/"), 60);
}

TEST_F(SweepReportTest, EscapesTextAndUsesNoExternalFiles) {
  const std::string page = Page();
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page,
              AllOf(HasSubstr(kSweepPageSignature), HasSubstr("night &lt;1&gt;"), HasSubstr("Noise &amp; exposure.")));
  EXPECT_THAT(page, Not(HasSubstr("night <1>")));
  EXPECT_THAT(page, HasSubstr("Incomplete: 3 of 23 flights have not been flown or collected yet."));
  EXPECT_THAT(page, Not(HasSubstr("Criteria not met"))) << "an incomplete sweep is not judged";
  sweep_.planned = sweep_.total = sweep_.results.size();
  EXPECT_THAT(Page(), AllOf(HasSubstr("Criteria not met"), Not(HasSubstr("Incomplete"))));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("{{")), Not(HasSubstr("href=\"figures/")), Not(HasSubstr("src=\"http"))));
}

TEST_F(SweepReportTest, HandlesSweepsWithoutFailuresOrFlights) {
  sweep_.results.resize(4);
  sweep_.spec.criteria.clear();
  EXPECT_THAT(Page(), AllOf(HasSubstr("No flight failed."), Not(HasSubstr("Criteria"))));
  sweep_.results.clear();
  EXPECT_THAT(Page(), AllOf(HasSubstr("23 of 23 flights have not been flown"), Not(HasSubstr("Pass rate"))));
}

TEST(SweepFigures, RecognizeNumbers) {
  EXPECT_EQ(AsNumber("-2.5e1"), -25.0);
  for (const char* text : {"", "[1, 2]", "3 m", "true", "nan"}) EXPECT_EQ(AsNumber(text), std::nullopt) << text;
}

TEST(SweepFigures, DivideDrawnValuesIntoFiveCells) {
  SweepOutcome sweep{.spec = {.axes = {{"start.yaw_deg", {}}, {"camera.noise_sigma", {"3", "20"}}}}};
  for (int i = 0; i <= 10; ++i) {
    sweep.results.push_back({.values = {std::to_string(i), "20"},
                             .row = {.verdict = i == 10 ? runner::Verdict::kFail : runner::Verdict::kPass}});
  }
  // The cells contain 0 and 1, 2 and 3, and so on; the last cell contains 8, 9 and 10.
  EXPECT_EQ(
      HeatMapFigure(sweep, 0, 1, "").csv,
      "x,y,passed,flown,percent\n0,1,2,2,100.00\n1,1,2,2,100.00\n2,1,2,2,100.00\n3,1,2,2,100.00\n4,1,2,3,66.67\n");
  for (SweepResult& result : sweep.results) result.values[0] = "1";
  EXPECT_THAT(HeatMapFigure(sweep, 0, 1, "").csv, HasSubstr("\n0,1,10,11,")) << "all values are equal";
}

TEST(SweepFigures, GroupManyDrawnValues) {
  SweepOutcome sweep{.spec = {.axes = {{"start.yaw_deg", {}}}}};
  for (int i = 0; i < 50; ++i) {
    sweep.results.push_back(
        {.values = {std::to_string(i)}, .row = {.verdict = i < 10 ? runner::Verdict::kFail : runner::Verdict::kPass}});
  }
  const std::string csv = DrawnValuesFigure(sweep, 0, {}).csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 50 + 5);
  EXPECT_THAT(csv, AllOf(HasSubstr("\n4.5,,,0.00,"), HasSubstr("\n14.5,,,100.00,"), HasSubstr("\n44.5,,,100.00,")));
}

}  // namespace
}  // namespace touchdown::sweeper
