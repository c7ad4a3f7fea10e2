// docs/paper contains the report of a full run. This test repeats the measurements that take seconds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/experiments/calibrations.h"
#include "scenarios/experiments/yaw.h"

namespace touchdown::experiments {
namespace {

namespace fs = std::filesystem;

// Tolerance for rounding differences between CPU types (docs/experiments.md). Errors of the estimator are hundreds of
// times larger than these differences.
constexpr double kTolerance = 0.01;

std::string Committed(const std::string& name) {
  const fs::path path = fs::path(TOUCHDOWN_SOURCE_DIR) / "docs" / "paper" / name;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Cells of the rows, without the header.
std::vector<std::vector<std::string>> CommittedRows(const std::string& name) {
  std::istringstream stream(Committed(name));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

Json MeasureAgain(const Experiment& experiment, const std::string& id) {
  for (const Measurement& measurement : experiment.measurements) {
    if (measurement.id == id) return measurement.measure({});
  }
  throw std::logic_error("no measurement " + id);
}

TEST(CommittedResults, ComeFromAFullRun) {
  const std::string readme = Committed("README.md");
  EXPECT_THAT(readme, testing::HasSubstr("Made by `touchdown paper --out DIR`"));
  EXPECT_THAT(Committed("paper.json"), testing::HasSubstr("\"quick\": false"));
}

TEST(CommittedResults, MatchTheYawErrorsOfThisBuild) {
  const Json again = MeasureAgain(YawExperiment({.seeds = 0}, {}), "yaw_32_cm");
  const auto committed = CommittedRows("figures/yaw_errors.csv");
  ASSERT_EQ(committed.size(), again.size());
  for (std::size_t i = 0; i < committed.size(); ++i) {
    ASSERT_EQ(committed[i].size(), again[i].size());
    for (std::size_t j = 0; j < committed[i].size(); ++j) {
      EXPECT_NEAR(std::stod(committed[i][j]), again[i][j].get<double>(), kTolerance) << "row " << i << ", column " << j;
    }
  }
}

TEST(CommittedResults, MatchTheCalibrationOfThisBuild) {
  const Json again = MeasureAgain(CalibrationsExperiment({.seeds = 1}), "calibration_1");
  const auto committed = CommittedRows("figures/calibrations.table.csv");
  const std::vector<const char*> keys{"focal_error_px",    "principal_point_error_px", "reprojection_px",
                                      "position_error_mm", "rotation_error_deg",       "imu_tilt_error_deg"};
  ASSERT_EQ(committed.size(), keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_NEAR(std::stod(committed[i].back()), again.at(keys[i]).get<double>(), kTolerance) << keys[i];
  }
}

}  // namespace
}  // namespace touchdown::experiments
