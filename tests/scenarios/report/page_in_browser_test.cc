// Tests the flight report, the paper report and the sweep report in Chromium. Each test writes a page and runs a script
// of this folder on it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "scenarios/cli/flight_folder.h"
#include "scenarios/experiments/paper_report.h"
#include "scenarios/report/flight_page.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/sweeper/analysis/rows_csv.h"
#include "scenarios/sweeper/page/sweep_report.h"
#include "tests/support/docs_image.h"
#include "tests/support/run_program.h"
#include "tests/support/synthetic_flight.h"
#include "tests/support/synthetic_sweep.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

class PageInABrowser : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const std::string tool : {TOUCHDOWN_NODE, TOUCHDOWN_CHROMIUM, TOUCHDOWN_NODE_MODULES "/playwright-core"}) {
      if (!fs::exists(tool)) GTEST_SKIP() << tool << " is missing: needs nodejs, npm, chromium and playwright-core";
    }
    setenv("NODE_MODULES", TOUCHDOWN_NODE_MODULES, 1);
    setenv("CHROMIUM", TOUCHDOWN_CHROMIUM, 1);
  }

  /// Writes a page without a video and returns its path.
  std::string PageOf(const std::string& name, const runner::Scenario& scenario, const runner::FlightLog& log) const {
    return folder_.Put(name, FlightPage(tests::FilesOf(scenario, log))).string();
  }

  /// Runs a script of this folder and expects that it succeeds.
  void RunScript(const std::string& script, const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"--test-reporter=spec",
                                 std::string(TOUCHDOWN_SOURCE_DIR) + "/tests/scenarios/report/" + script};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const tests::ProgramRun run = tests::RunProgram(TOUCHDOWN_NODE, all, folder_.path());
    EXPECT_EQ(run.status, 0) << run.out << run.err;
  }

  const tests::TemporaryFolder folder_;
};

runner::Scenario TakeoffHoverLand() {
  return runner::LoadScenario(fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "takeoff_hover_land.yaml");
}

/// Tolerance of the screenshot. The page of the same flight differs by 0.05, because of measured times; the page of
/// another seed by 2.5; a page on which everything below a table moved by 2 px by 5.6. To update the screenshot:
///   TOUCHDOWN_WRITE_DOCS=1 build/release/tests/scenarios/report/report_browser_tests
constexpr double kSameLayout = 4.0;

TEST_F(PageInABrowser, FlightReportSupportsInteractionAndMatchesDocs) {
  const runner::Scenario scenario = TakeoffHoverLand();
  const fs::path flight = folder_ / "flight";
  cli::FlyIntoFolder(scenario, flight);

  runner::Scenario marked = scenario;
  marked.pad.marks = {{.shape = models::PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01},
                      {.shape = models::PadMarking::Shape::kBar,
                       .center_m = {-0.02, 0.05},
                       .length_m = 0.02,
                       .width_m = 0.004,
                       .angle_deg = 30.0}};
  runner::FlightLog without_frames = tests::SyntheticFlight(scenario, 2.0);
  without_frames.frames.clear();
  runner::FlightLog nothing;
  nothing.time = scenario.time;
  RunScript("page_in_browser.mjs",
            {(flight / "report.html").string(), PageOf("marked.html", marked, tests::SyntheticFlight(marked, 2.0)),
             PageOf("without_frames.html", scenario, without_frames), PageOf("nothing.html", scenario, nothing)});

  const std::string screenshot = (folder_ / "report.png").string();
  RunScript("screenshot_page.mjs", {(flight / "report.html").string(), screenshot, "1600", "1500"});
  tests::ExpectDocsImage("report.png", cv::imread(screenshot), kSameLayout);
}

TEST_F(PageInABrowser, PaperReportFitsWideAndNarrowWindows) {
  experiments::PaperSection section{{.id = "yaw", .title = "Yaw from the letter"}};
  section.paragraphs = {"Each <b>method</b> on the same frames."};
  for (const std::string name : {"position", "attitude", "error"}) {
    section.figures.push_back({.name = name,
                               .title = name,
                               .caption = "Over time.",
                               .csv = "t_s,x_m\n0,1\n1,3\n2,2\n",
                               .plot = "plot data using 't_s':'x_m' with lines lc rgb INK\n"});
  }
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", cv::Mat1b(480, 1920, 100), jpeg);
  section.images.push_back({.name = "stages",
                            .title = "Stages",
                            .caption = "A wide image.",
                            .jpeg = {jpeg.begin(), jpeg.end()},
                            .csv = "view\n1\n"});
  section.tables.push_back(
      {.name = "methods", .caption = "All.", .head = {"method", "error, deg"}, .rows = {{"ellipse", "2.5"}}});
  section.compared = {{.quantity = "yaw", .unit = "deg", .published = 3.0, .ours = 0.4, .spread = "", .why = ""}};
  for (const auto& [name, content] : experiments::ReportFiles({.command = "touchdown paper"}, {section})) {
    folder_.Put(name, content);
  }
  RunScript("section_page_in_browser.mjs", {(folder_ / "report.html").string(), "4"});
}

TEST_F(PageInABrowser, SweepReportFitsWideAndNarrowWindows) {
  const fs::path page = folder_.Put(
      "report.html",
      sweeper::SweepPage(tests::SyntheticSweep(), sweeper::Summarize(tests::SyntheticSweep()), folder_.path()));
  // Pass rates over three parameters and three pairs of parameters, touchdown positions, and a histogram.
  RunScript("section_page_in_browser.mjs", {page.string(), "8"});
}

/// Builds the report of the wind sweep from its rows in docs/sweeps.
TEST_F(PageInABrowser, WindSweepReportMatchesDocs) {
  const fs::path root = TOUCHDOWN_SOURCE_DIR;
  const sweeper::SweepFile file = sweeper::LoadSweepFile(root / "scenarios/sweeps/wind.yaml");
  sweeper::SweepOutcome sweep{.spec = sweeper::SpecOf(file),
                              .results = sweeper::ReadRowsCsv(root / "docs/sweeps/wind.csv").results};
  sweep.planned = sweep.total = sweep.results.size();
  for (sweeper::SweepResult& result : sweep.results)
    result.row.scenario = runner::ScenarioYaml(runner::LoadScenario(file.base));
  const fs::path page = folder_.Put("report.html", sweeper::SweepPage(sweep, sweeper::Summarize(sweep), "out/wind"));
  const std::string screenshot = (folder_ / "sweep.png").string();
  RunScript("screenshot_page.mjs", {page.string(), screenshot, "1200", "1290"});
  tests::ExpectDocsImage("sweep.png", cv::imread(screenshot), 1.0);
}

}  // namespace
}  // namespace touchdown::report
