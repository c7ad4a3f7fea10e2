#include "scenarios/report/flight_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>

#include "models/angles.h"
#include "tests/support/synthetic_flight.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tests::FilesOf;
using tests::SyntheticFlight;
using tests::ThrowsInputError;
using Json = nlohmann::json;

runner::Scenario Parsed(const std::string& more = "") {
  return runner::ParseScenario("script: [{do: takeoff, height_m: 1}, {do: land}]\n" + more, "made.yaml", ".");
}

FlightFiles MadeFiles(double duration_s = 2.0) { return FilesOf(Parsed(), SyntheticFlight(Parsed(), duration_s)); }

/// Data embedded in the page for its script.
Json DataOf(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"flight\">";
  const std::size_t at = page.find(begin) + begin.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

Json DataOf(const runner::Scenario& scenario, const runner::FlightLog& log) {
  return DataOf(FlightPage(FilesOf(scenario, log)));
}

/// Times and values of a curve.
struct Curve {
  std::vector<double> t_s;
  std::vector<Json> values;

  double At(double time_s) const {
    const auto found = std::find_if(t_s.begin(), t_s.end(), [&](double t) { return std::abs(t - time_s) < 1e-3; });
    return values.at(static_cast<std::size_t>(found - t_s.begin())).get<double>();
  }
};

/// Curve with the given plot title and label.
Curve CurveOf(const Json& data, const std::string& title, const std::string& label) {
  for (const Json& plot : data.at("plots")) {
    if (plot.at("title") != title) continue;
    for (const Json& sheet : plot.at("sheets")) {
      for (const Json& series : sheet.at("series")) {
        if (series.at("label") == label) return {sheet.at("t_s"), series.at("values")};
      }
    }
  }
  ADD_FAILURE() << "no curve " << label << " in plot " << title;
  return {};
}

Eigen::Isometry3d PoseWithYaw(double yaw_deg, double x_m) {
  Eigen::Isometry3d X_WB(Eigen::AngleAxisd(models::DegToRad(yaw_deg), Eigen::Vector3d::UnitZ()));
  X_WB.translation() = Eigen::Vector3d(x_m, 0.0, 1.0);
  return X_WB;
}

TEST(FlightPage, TitleContainsScenarioSeedAndVerdict) {
  runner::Scenario scenario = Parsed("seed: 7\n");
  scenario.name = "gusts";
  EXPECT_THAT(FlightPage(FilesOf(scenario, SyntheticFlight(scenario, 2.0))),
              HasSubstr("<title>gusts, seed 7: Passed</title>"));
  runner::FlightLog crash = SyntheticFlight(scenario, 2.0);
  crash.outcome = runner::Outcome::kCrashed;
  EXPECT_THAT(FlightPage(FilesOf(scenario, crash)), HasSubstr("<title>gusts, seed 7: Failed</title>"));
  crash.outcome = runner::Outcome::kError;
  EXPECT_THAT(FlightPage(FilesOf(scenario, crash)), HasSubstr("<title>gusts, seed 7: Error</title>"));
}

TEST(FlightPage, ReferencesOnlyVideo) {
  FlightFiles files = MadeFiles();
  files.has_video = true;
  const std::string page = FlightPage(files);
  const std::regex address(R"-((src|href)="([^"]*)")-");
  for (auto match = std::sregex_iterator(page.begin(), page.end(), address); match != std::sregex_iterator(); ++match) {
    EXPECT_THAT((*match)[2].str(), testing::AnyOf("flight.mp4", "data:,"));
  }
  EXPECT_THAT(page, HasSubstr("src=\"flight.mp4\""));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
}

TEST(FlightPage, OmitsVideoWhenThereIsNone) {
  const std::string page = FlightPage(MadeFiles());
  EXPECT_THAT(page, Not(HasSubstr("flight.mp4\"")));
  EXPECT_THAT(page, HasSubstr("This flight has no video."));
}

TEST(FlightPage, EscapesUserText) {
  runner::Scenario scenario = Parsed();
  scenario.description = "{{scenario}} </script><script>alert(1)</script>";
  const std::string page = FlightPage(FilesOf(scenario, SyntheticFlight(scenario, 1.0)));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("{{scenario}} &lt;/script&gt;"));
}

TEST(FlightPage, KeepsExtremesOfLongFlight) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog log = SyntheticFlight(scenario, 66.0);
  log.ticks[6000].truth.X_WB.translation().z() = 1.75;
  log.ticks[9001].truth.X_WB.translation().z() = 0.625;
  log.frames[2000].vision_ms = 40.0;
  const std::string page = FlightPage(FilesOf(scenario, log));
  EXPECT_LT(page.size(), 3'000'000u);
  const Curve height = CurveOf(DataOf(page), "z, height", "truth");
  EXPECT_LT(height.t_s.size(), log.ticks.size() / 2);
  EXPECT_EQ(height.At(30.0), 1.75);
  EXPECT_EQ(height.At(45.005), 0.625);
  EXPECT_EQ(CurveOf(DataOf(page), "Vision time per frame", "time").At(2000.0 / 60.0), 40.0);
}

TEST(FlightPage, ResolvesYawAmbiguityTowardsTruth) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog log = SyntheticFlight(scenario, 1.0);
  for (runner::TickRecord& record : log.ticks) record.truth.X_WB = PoseWithYaw(170.0, 0.3);
  for (runner::FrameRecord& frame : log.frames) frame.X_WB = PoseWithYaw(170.0, 0.3);
  log.frames[30].pose->X_WB = PoseWithYaw(-8.0, -0.29);
  log.frames[31].pose->X_WB = PoseWithYaw(-11.0, -0.31);
  const Json data = DataOf(scenario, log);
  EXPECT_NEAR(CurveOf(data, "Yaw", "vision").At(30.0 / 60.0), 172.0, 1e-6);
  EXPECT_NEAR(CurveOf(data, "Yaw", "vision").At(31.0 / 60.0), 169.0, 1e-6);
  EXPECT_NEAR(CurveOf(data, "x", "vision").At(30.0 / 60.0), 0.29, 1e-6);
  EXPECT_NEAR(CurveOf(data, "Vision position error (unfiltered, vision minus truth)", "x").At(31.0 / 60.0), 10.0, 1e-6);
  EXPECT_NEAR(CurveOf(data, "Vision attitude error (unfiltered, vision minus truth)", "yaw").At(31.0 / 60.0), -1.0,
              1e-3);
}

TEST(FlightPage, UnwrapsYaw) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog log = SyntheticFlight(scenario, 1.0);
  for (std::size_t i = 0; i < log.ticks.size(); ++i) {
    log.ticks[i].truth.X_WB = PoseWithYaw(static_cast<double>(i) * 3.0, 0.0);
  }
  const Curve yaw = CurveOf(DataOf(scenario, log), "Yaw", "truth");
  EXPECT_NEAR(yaw.values.back().get<double>(), 600.0, 1e-6);
}

TEST(FlightPage, LeavesGapsWhereValuesAreMissing) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog log = SyntheticFlight(scenario, 2.0);
  log.frames.erase(log.frames.begin() + 60, log.frames.begin() + 66);
  const Json data = DataOf(scenario, log);
  EXPECT_TRUE(CurveOf(data, "x", "estimate").values.front().is_null());
  const Curve error = CurveOf(data, "Vision position error (unfiltered, vision minus truth)", "x");
  EXPECT_TRUE(error.values.front().is_null());
  const auto gap = std::find_if(error.t_s.begin(), error.t_s.end(), [](double t) { return t > 60.0 / 60.0; });
  EXPECT_TRUE(error.values[static_cast<std::size_t>(gap - error.t_s.begin())].is_null());
  EXPECT_LT(*gap, 65.0 / 60.0);
}

TEST(FlightPage, ContainsPhasesEventsAndTouchdown) {
  const runner::Scenario scenario = Parsed("events: [{at_s: 0.5, do: push, force_n: [3, 4, 0], duration_s: 0.25}]\n");
  const Json data = DataOf(scenario, SyntheticFlight(scenario, 2.0));
  ASSERT_EQ(data.at("phases").size(), 5u);
  EXPECT_EQ(data["phases"][2]["name"], "hover");
  EXPECT_NEAR(data["phases"][2]["from_s"].get<double>(), 0.4, 0.006);
  EXPECT_NEAR(data["phases"][2]["to_s"].get<double>(), 1.6, 0.006);
  EXPECT_EQ(data["events"][0], Json::parse(R"({"name": "push 5 N", "from_s": 0.5, "to_s": 0.75})"));
  EXPECT_NEAR(data["touchdown"]["t_s"].get<double>(), 1.8, 0.006);
  EXPECT_EQ(data["touchdown"]["y_m"], 0.05);
}

TEST(FlightPage, ShowsTouchdownFromMetricsOnly) {
  const runner::Scenario scenario = Parsed("");
  runner::FlightLog log = SyntheticFlight(scenario, 2.0);
  log.touchdown->at.tick += 5;
  log.touchdown->at.X_WB.translation().y() = 0.07;
  const Json data = DataOf(scenario, log);
  EXPECT_NEAR(data["touchdown"]["t_s"].get<double>(), scenario.time.ToSeconds(log.touchdown->at.tick), 1e-4);
  EXPECT_EQ(data["touchdown"]["y_m"], 0.07);
  log.touchdown.reset();
  EXPECT_TRUE(DataOf(scenario, log)["touchdown"].is_null()) << "although flight.csv has a contact during the landing";
}

TEST(FlightPage, ComparesErrorsWithTableOne) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog log = SyntheticFlight(scenario, 1.0);
  for (runner::FrameRecord& frame : log.frames) {
    if (frame.pose) frame.pose->X_WB.translation().x() += 0.01685;
  }
  EXPECT_THAT(FlightPage(FilesOf(scenario, log)),
              HasSubstr("<th scope=\"row\">XY</th><td class=\"number\"><b>16.9</b><span class=\"unit\"> mm</span></td>"
                        "<td class=\"number\">38.8</td><td class=\"number\">0.43</td>"
                        "<td class=\"number\">33.7</td><td class=\"number\">0.50</td>"));
}

TEST(FlightPage, HandlesFlightsWithoutData) {
  const runner::Scenario scenario = Parsed();
  runner::FlightLog blind = SyntheticFlight(scenario, 1.0);
  for (runner::FrameRecord& frame : blind.frames) {
    frame.status = estimator::FrameStatus::kNotFound;
    frame.reason = "no_component";
    frame.pose.reset();
  }
  runner::FlightLog without_frames = SyntheticFlight(scenario, 1.0);
  without_frames.frames.clear();
  runner::FlightLog nothing;
  nothing.time = scenario.time;
  runner::FlightLog one_tick = nothing;
  one_tick.ticks.emplace_back();
  for (const runner::FlightLog* log : {&blind, &without_frames, &nothing, &one_tick}) {
    const std::string page = FlightPage(FilesOf(scenario, *log));
    EXPECT_EQ(DataOf(page).at("plots").size(), 13u);
    EXPECT_THAT(page, HasSubstr("<th scope=\"row\">XY</th><td class=\"number\"><b>–</b>"));
  }
}

TEST(FlightPage, ThrowsNamingFileAndKeyForInvalidInput) {
  const FlightFiles good = MadeFiles();
  const auto page_with = [&](const std::function<void(FlightFiles&)>& damage) {
    FlightFiles files = good;
    damage(files);
    return [files] { FlightPage(files); };
  };
  EXPECT_NO_THROW(FlightPage(good));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.flight_csv.resize(f.flight_csv.size() / 2); }),
              ThrowsInputError(StartsWith("flight/flight.csv:")));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.flight_csv.replace(f.flight_csv.find("true_x_m"), 8, "true_u_m"); }),
              ThrowsInputError("flight/flight.csv:1: true_x_m: no such column"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.frames_csv.insert(f.frames_csv.find('\n') + 3, "x"); }),
              ThrowsInputError("flight/frames.csv:2: t_s: 'x0' is not a finite number"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.frame_timing_csv = "tick,render_ms,vision_ms\n"; }),
              ThrowsInputError("flight/frame_timing.csv:1: tick: must equal the column tick of frames.csv"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.result_json = "{\n\"log_sha256\""; }),
              ThrowsInputError("flight/result.json:2: invalid JSON"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.result_json = "{\"log_sha256\": \"\"}"; }),
              ThrowsInputError("flight/result.json: metrics: missing key"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.timing_json = "[]"; }),
              ThrowsInputError("flight/timing.json: vision_ms_mean: missing key"));
  EXPECT_THAT(page_with([](FlightFiles& f) { f.scenario_yaml += "fps: 60\n"; }),
              ThrowsInputError(HasSubstr("fps: unknown key")));
}

}  // namespace
}  // namespace touchdown::report
