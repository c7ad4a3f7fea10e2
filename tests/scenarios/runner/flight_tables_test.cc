#include "scenarios/runner/flight_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "scenarios/runner/fly.h"
#include "scenarios/util/sha256.h"

namespace touchdown::runner {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Rows of a table by column name. Fails if a row and the header have different numbers of cells.
std::vector<Row> Read(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = Cells(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = Cells(line);
    EXPECT_EQ(cells.size(), header.size());
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), header.size()); ++i) row[header[i]] = cells[i];
    EXPECT_EQ(row.size(), header.size()) << "two columns of one name";
  }
  return rows;
}

FlightLog SmallLog() {
  FlightLog log;
  TickRecord first;
  first.truth.X_WB.translation() << 0.1, -0.2, 1.0 / 3.0;
  first.truth.w_WB_B.z() = models::DegToRad(90.0);
  first.control.phase = controller::Phase::kRamp;
  TickRecord second = first;
  second.truth.tick = 6;
  second.estimate.motion = models::VehicleEstimate::Motion{{1, 2, 3}, {4, 5, 6}};
  second.estimate.pad_seen = 4;
  log.ticks = {first, second};
  FrameRecord blind;
  FrameRecord seen;
  seen.mid_exposure = 20;
  seen.status = estimator::FrameStatus::kOk;
  seen.pose.emplace();
  seen.pose->covariance(0, 5) = 0.25;
  seen.pad_px = Eigen::Vector2d(10.5, 20.25);
  seen.vision_ms = 3.5;
  seen.geometry_ms = 1.25;
  log.frames = {blind, seen};
  SensorRecord<sim::TrackingSystem> tracked;
  tracked.reading.tick = 12;
  tracked.reading.X_WB =
      Eigen::Translation3d(0.5, 0.0, 1.0) * Eigen::AngleAxisd(models::kPi / 2, Eigen::Vector3d::UnitZ());
  std::get<std::vector<SensorRecord<sim::TrackingSystem>>>(log.sensors).push_back(tracked);
  log.end = 6;
  log.outcome = Outcome::kHovered;
  return log;
}

TEST(FlightCsv, HasRowPerTickThatReadsBackExactly) {
  const std::vector<Row> rows = Read(FlightCsv(SmallLog()));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].at("tick"), "6");
  EXPECT_EQ(rows[1].at("t_s"), "0.005");
  EXPECT_EQ(rows[0].at("phase"), "ramp");
  EXPECT_EQ(std::stod(rows[0].at("true_z_m")), 1.0 / 3.0);
  EXPECT_EQ(std::stod(rows[0].at("true_wz_deg_s")), 90.0);
  EXPECT_EQ(rows[0].at("est_x_m"), "");
  EXPECT_EQ(rows[0].at("pad_seen_tick"), "");
  EXPECT_EQ(rows[1].at("est_vz_m_s"), "6");
  EXPECT_EQ(rows[1].at("pad_seen_tick"), "4");
}

TEST(FramesCsv, LeavesCellsEmptyWithoutPose) {
  const std::vector<Row> rows = Read(FramesCsv(SmallLog()));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("status"), "not_found");
  EXPECT_EQ(rows[0].at("x_m"), "");
  EXPECT_EQ(rows[0].at("cov_x_rz"), "");
  EXPECT_EQ(rows[1].at("status"), "ok");
  EXPECT_EQ(rows[1].at("cov_x_rz"), "0.25");
  EXPECT_EQ(rows[1].at("pad_u_px"), "10.5");
  EXPECT_EQ(rows[1].at("true_pad_u_px"), "");
}

TEST(FramesCsv, ContainsNoWallClockTime) {
  EXPECT_EQ(FramesCsv(SmallLog()).find("3.5"), std::string::npos);
  EXPECT_EQ(Read(FrameTimingCsv(SmallLog()))[1].at("vision_ms"), "3.5");
  EXPECT_EQ(Read(FrameTimingCsv(SmallLog()))[1].at("geometry_ms"), "1.25");
}

TEST(SensorTables, HasRowPerReadingWithTruth) {
  const NamedText table = SensorTables(SmallLog()).at(0);
  EXPECT_EQ(table.first, "tracking.csv");
  const std::vector<Row> rows = Read(table.second);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("tick"), "12");
  EXPECT_EQ(rows[0].at("x_m"), "0.5");
  EXPECT_NEAR(std::stod(rows[0].at("yaw_deg")), 90.0, 1e-9);
  EXPECT_EQ(rows[0].at("true_x_m"), "0");
}

TEST(JudgeFlight, HashesFlightAndFramesWithoutWallClockTimes) {
  Scenario scenario;
  scenario.expect = Outcome::kHovered;
  FlightLog log = SmallLog();
  const FlightResult result = JudgeFlight(scenario, log);
  EXPECT_EQ(result.verdict, Verdict::kPass);
  EXPECT_EQ(result.log_sha256, util::Sha256(FlightCsv(log) + FramesCsv(log)));
  log.frames[1].vision_ms = 99.0;
  log.wall_s = 3.0;
  EXPECT_EQ(JudgeFlight(scenario, log).log_sha256, result.log_sha256);
  log.frames[1].pose->covariance(5, 5) = 1e-300;
  EXPECT_NE(JudgeFlight(scenario, log).log_sha256, result.log_sha256);
}

TEST(LogDigest, EqualsDigestOfFilesEvenForLongLog) {
  FlightLog log = SmallLog();
  log.ticks.resize(5000, log.ticks.front());
  EXPECT_GT(FlightCsv(log).size(), 4u << 16);
  EXPECT_EQ(LogDigest(log), util::Sha256(FlightCsv(log) + FramesCsv(log)));
}

TEST(JudgeFlight, ReportsErrorForFailedSimulation) {
  FlightLog log = SmallLog();
  log.outcome = Outcome::kError;
  EXPECT_EQ(JudgeFlight(Scenario(), log).verdict, Verdict::kError);
}

TEST(ResultJson, HasKeysOfSchemaInOrder) {
  const Scenario scenario;
  const std::string json = ResultJson(scenario, JudgeFlight(scenario, SmallLog()));
  std::size_t last = 0;
  for (const char* key : {"schema", "version", "scenario", "seed", "estimator", "outcome", "verdict", "checks",
                          "metrics", "log_sha256", "platform"}) {
    const std::size_t at = json.find("\n  \"" + std::string(key) + "\":");
    ASSERT_NE(at, std::string::npos) << key;
    EXPECT_GE(at, last) << key;
    last = at;
  }
}

}  // namespace
}  // namespace touchdown::runner
