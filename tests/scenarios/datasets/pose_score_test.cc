#include "scenarios/datasets/pose_score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "models/error.h"
#include "scenarios/runner/flight_tables.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/pad_view.h"
#include "scenarios/runner/tum_trajectory.h"
#include "tests/support/synthetic_flight.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::datasets {
namespace {

using ::testing::HasSubstr;

runner::Scenario Landing() {
  return runner::LoadScenario(std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "landing.yaml");
}

/// Directory and metrics of a synthetic flight.
class PoseScoreTest : public ::testing::Test {
 protected:
  PoseScoreTest() {
    const models::CameraModel& camera = scenario_.camera.model;
    for (runner::FrameRecord& frame : log_.frames) {
      const Eigen::Isometry3d X_WC = frame.X_WB * scenario_.vehicle.X_BC();
      frame.ring_in_view = runner::WholeRingInView(camera, scenario_.pad, X_WC);
      frame.true_pad_px = camera.Project(X_WC.inverse() * Eigen::Vector3d::Zero());
    }
    folder_.Put("flight/scenario.yaml", runner::ScenarioYaml(scenario_));
    folder_.Put("flight/frames.csv", runner::FramesCsv(log_));
    folder_.Put("flight/truth.tum", runner::TumText(runner::TrueTrajectory(log_), log_.time));
    metrics_ = runner::ComputeMetrics(log_);
    poses_ = ReadTumFile(folder_.Put("estimate.tum", runner::TumText(runner::EstimatedTrajectory(log_), log_.time)));
  }
  PoseScore Score(const std::vector<TimedPose>& poses) const { return ScorePoses(poses, folder_ / "flight"); }

  tests::TemporaryFolder folder_;
  runner::Scenario scenario_ = Landing();
  runner::FlightLog log_ = tests::SyntheticFlight(scenario_, 3.0);
  runner::Metrics metrics_;
  std::vector<TimedPose> poses_;
};

TEST_F(PoseScoreTest, ReproducesTheMetricsOfAFlightFromItsPoses) {
  const PoseScore score = Score(poses_);
  EXPECT_EQ(score.poses, poses_.size());
  EXPECT_EQ(score.outside, 0u);
  ASSERT_EQ(score.metrics.size(), 10u);
  for (const auto& [name, value] : score.metrics) {
    if (name == "estimate.false_pads") continue;  // The metric of a flight also counts frames without a pose.
    EXPECT_NEAR(value, metrics_.at(name), 1e-9 + 1e-6 * std::abs(metrics_.at(name))) << name;
  }
}

TEST_F(PoseScoreTest, MeasuresAnOffsetWithoutAlignment) {
  std::vector<TimedPose> poses = ReadTumFile(folder_ / "flight/truth.tum");
  for (TimedPose& pose : poses) pose.X_WB.translation() += Eigen::Vector3d(0.03, 0.04, 0.12);
  const PoseScore score = Score(poses);
  EXPECT_NEAR(score.metrics.at("estimate.xy_rmse_m"), 0.05, 1e-9);
  EXPECT_NEAR(score.metrics.at("estimate.z_rmse_m"), 0.12, 1e-9);
  EXPECT_NEAR(score.metrics.at("estimate.xyz_rmse_m"), 0.13, 1e-9);
  EXPECT_NEAR(score.metrics.at("estimate.yaw_rmse_deg"), 0.0, 1e-5);
  EXPECT_EQ(score.metrics.at("estimate.availability"), 1.0);
}

TEST_F(PoseScoreTest, InterpolatesTheTruthAndIgnoresPosesOutsideIt) {
  const std::vector<TimedPose> truth = ReadTumFile(folder_ / "flight/truth.tum");
  std::vector<TimedPose> poses(2);
  poses[0].t_s = 0.5 * (truth[100].t_s + truth[101].t_s);
  poses[0].X_WB.translation() = 0.5 * (truth[100].X_WB.translation() + truth[101].X_WB.translation());
  poses[0].X_WB.linear() = truth[100].X_WB.linear();
  poses[1].t_s = truth.back().t_s + 1.0;
  const PoseScore score = Score(poses);
  EXPECT_EQ(score.poses, 1u);
  EXPECT_EQ(score.outside, 1u);
  EXPECT_NEAR(score.metrics.at("estimate.xyz_rmse_m"), 0.0, 1e-9);
  poses.erase(poses.begin());
  EXPECT_THROW(Score(poses), InputError);
}

TEST_F(PoseScoreTest, CountsAPoseWithADistantPadPixelAsAFalsePad) {
  std::vector<TimedPose> poses = poses_;
  poses[3].X_WB.translation().x() += 0.5;
  EXPECT_EQ(Score(poses).metrics.at("estimate.false_pads"), Score(poses_).metrics.at("estimate.false_pads") + 1.0);
}

TEST_F(PoseScoreTest, ReadsTheTruthOfARecording) {
  folder_.Put("recording/mav0/cam0/data.csv", "0,0.png\n");
  folder_.Put("recording/mav0/state_groundtruth_estimate0/data.csv",
              "#t,p,q\n0,0,0,1,1,0,0,0\n40000000,0.1,0,1,1,0,0,0\n");
  std::vector<TimedPose> poses(1);
  poses[0].t_s = 0.02;
  poses[0].X_WB.translation() << 0.05, 0.0, 1.5;
  const PoseScore score = ScorePoses(poses, folder_ / "recording");
  EXPECT_NEAR(score.metrics.at("estimate.z_rmse_m"), 0.5, 1e-9);
  EXPECT_NEAR(score.metrics.at("estimate.xy_rmse_m"), 0.0, 1e-9);
  EXPECT_FALSE(score.metrics.contains("estimate.availability"));
}

TEST_F(PoseScoreTest, RejectsADirectoryWithoutTruth) {
  try {
    ScorePoses(poses_, folder_.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("not a flight directory or a recording"));
  }
}

}  // namespace
}  // namespace touchdown::datasets
