#include "scenarios/experiments/paper_report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace touchdown::experiments {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string Jpeg() {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", cv::Mat1b(8, 8, 100), bytes);
  return {bytes.begin(), bytes.end()};
}

std::vector<PaperSection> Sections() {
  PaperSection section{{.id = "yaw", .title = "Yaw <of> the letter"}};
  section.paragraphs = {"With <b>words</b>."};
  section.figures.push_back({.name = "errors",
                             .title = "Errors",
                             .caption = "Over yaw.",
                             .csv = "x,y\n1,2\n2,3\n",
                             .plot = "plot data using 'x':'y' with lines lc rgb INK\n"});
  section.images.push_back({.name = "image", .title = "Image", .caption = "View.", .jpeg = Jpeg(), .csv = "view\n1\n"});
  section.tables.push_back(
      {.name = "methods", .caption = "All.", .head = {"method", "error, deg"}, .rows = {{"H", "2.5"}}});
  section.compared = {
      {.quantity = "mean |x|", .unit = "mm", .published = 24.0, .ours = 6.0, .spread = "a, b", .why = "W"},
      {.quantity = "yaw", .unit = "deg", .published = 3.0, .ours = 4.5, .spread = "", .why = ""},
      {.quantity = "cost", .unit = "", .published = std::nullopt, .ours = 0.1, .spread = "", .why = ""},
      {.quantity = "roll", .unit = "deg", .published = 1.0, .ours = std::nullopt, .spread = "none", .why = ""}};
  return {section};
}

class PaperReportTest : public testing::Test {
 protected:
  std::map<std::string, std::string> files_ = ReportFiles(
      {.signature = "<!-- signature -->", .quick = true, .command = "touchdown paper", .platform = {{"cpu", "x"}}},
      Sections());
};

TEST_F(PaperReportTest, WritesEveryFigureAndTableToAFile) {
  for (const char* name :
       {"figures/errors.csv", "figures/errors.pdf", "figures/errors.svg", "figures/image.jpg", "figures/image.pdf",
        "figures/methods.table.csv", "report.html", "README.md", "summary.csv"}) {
    EXPECT_FALSE(files_[name].empty()) << name;
  }
  EXPECT_EQ(files_["figures/errors.csv"], "x,y\n1,2\n2,3\n");
  EXPECT_EQ(files_["figures/methods.table.csv"], "method,\"error, deg\"\nH,2.5\n");
  EXPECT_EQ(files_["figures/image.jpg"], Jpeg());
  EXPECT_EQ(files_["figures/image.csv"], "view\n1\n");
}

TEST_F(PaperReportTest, SummarizesTheComparisonWithThePublishedValues) {
  EXPECT_EQ(files_["summary.csv"],
            "section,quantity,unit,published,ours,spread,kept,why\n"
            "yaw,mean |x|,mm,24,6,\"a, b\",yes,W\n"
            "yaw,yaw,deg,3,4.5,,no,\n"
            "yaw,cost,,,0.1,,,\n"
            "yaw,roll,deg,1,,none,no,\n");
  EXPECT_THAT(files_["report.html"], HasSubstr("1 of 3 at or below the published"));
  EXPECT_THAT(files_["README.md"], HasSubstr("| mean \\|x\\| | mm | 24 | 6 | 0.25 | at or below | a, b |"));
  EXPECT_THAT(files_["README.md"], HasSubstr("| yaw | deg | 3 | 4.5 | 1.50 | above |"));
  EXPECT_THAT(files_["README.md"], HasSubstr("| roll | deg | 1 | – | – | none | none |"));
}

TEST_F(PaperReportTest, ShowsOnlySmallFiguresInTheReadme) {
  EXPECT_THAT(files_["README.md"], HasSubstr("![Errors](figures/errors.svg)"));
  EXPECT_THAT(files_["README.md"], HasSubstr("![Image](figures/image.jpg)"));

  PaperSection section{{.id = "flight", .title = "Flight"}};
  std::string csv = "x,y\n";
  for (int i = 0; i < 20000; ++i) csv += fmt::format("{},{}\n", i, i % 7);
  section.figures.push_back({.name = "series",
                             .title = "Series",
                             .caption = "Over time.",
                             .csv = csv,
                             .plot = "plot data using 'x':'y' with lines lc rgb INK\n"});
  auto files = ReportFiles({.command = "touchdown paper"}, {section});
  EXPECT_THAT(files["report.html"], HasSubstr("Series"));
  EXPECT_THAT(files["README.md"], Not(HasSubstr("series.svg")));
}

TEST_F(PaperReportTest, PageIsSelfContained) {
  const std::string& page = files_["report.html"];
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page, HasSubstr("<!-- signature -->"));
  EXPECT_THAT(page, HasSubstr("Yaw &lt;of&gt; the letter"));
  EXPECT_THAT(page, HasSubstr("With <b>words</b>."));
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("data:image/jpeg;base64,/9j/"));
  EXPECT_THAT(page, HasSubstr("Do not quote its values"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

}  // namespace
}  // namespace touchdown::experiments
