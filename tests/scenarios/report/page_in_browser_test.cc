// The page of a real flight in Chromium, as a reader uses it: page_in_browser.mjs, which ctest runs through this.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "scenarios/flight/scenario.h"
#include "scenarios/report/flight_folder.h"
#include "scenarios/report/flight_page.h"
#include "tests/support/made_flight.h"
#include "tests/support/run_program.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

class PageInABrowser : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    setenv("NODE_MODULES", TOUCHDOWN_NODE_MODULES, 1);
    setenv("CHROMIUM", TOUCHDOWN_CHROMIUM, 1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Leaves a page that has no video beside it.
  std::string PageOf(const std::string& name, const Scenario& scenario, const FlightLog& log) const {
    std::ofstream(folder_ / name, std::ios::binary) << FlightPage(tests::FilesOf(scenario, log));
    return (folder_ / name).string();
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / "page_in_browser_test";
};

Scenario TakeoffHoverLand() {
  return LoadScenario(fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "takeoff_hover_land.yaml");
}

TEST_F(PageInABrowser, DoesWhatItsReaderAsks) {
  const Scenario scenario = TakeoffHoverLand();
  const fs::path flight = folder_ / "flight";
  FlyIntoFolder(scenario, flight);

  Scenario marked = scenario;
  marked.pad.marks = {{.shape = models::PadMark::Shape::kDisc, .centre_m = {0.02, 0.05}, .diameter_m = 0.01},
                      {.shape = models::PadMark::Shape::kBar,
                       .centre_m = {-0.02, 0.05},
                       .length_m = 0.02,
                       .width_m = 0.004,
                       .angle = models::DegToRad(30.0)}};
  FlightLog without_frames = tests::MadeFlight(scenario, 2.0);
  without_frames.frames.clear();
  FlightLog nothing;
  nothing.time = scenario.time;
  const tests::ProgramRun run = tests::RunProgram(
      TOUCHDOWN_NODE,
      {"--test-reporter=spec", std::string(TOUCHDOWN_SOURCE_DIR) + "/tests/scenarios/report/page_in_browser.mjs",
       (flight / "report.html").string(), PageOf("marked.html", marked, tests::MadeFlight(marked, 2.0)),
       PageOf("without_frames.html", scenario, without_frames), PageOf("nothing.html", scenario, nothing)},
      folder_);
  EXPECT_EQ(run.status, 0) << run.out << run.err;
}

}  // namespace
}  // namespace touchdown::scenarios
