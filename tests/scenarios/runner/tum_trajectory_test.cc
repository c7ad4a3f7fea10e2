#include "scenarios/runner/tum_trajectory.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "models/angles.h"

namespace touchdown::runner {
namespace {

struct Line {
  double t_s;
  Eigen::Vector3d p;
  Eigen::Quaterniond q;
};

std::vector<Line> ReadTum(const std::string& text) {
  std::istringstream lines(text);
  std::vector<Line> trajectory;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    Line& pose = trajectory.emplace_back();
    numbers >> pose.t_s >> pose.p.x() >> pose.p.y() >> pose.p.z();
    numbers >> pose.q.x() >> pose.q.y() >> pose.q.z() >> pose.q.w();
    EXPECT_TRUE(numbers && numbers.peek() == EOF) << line;
  }
  return trajectory;
}

Eigen::Isometry3d Turned(double height) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan({0.1, -0.2, 2.0});
  X_WB.translation() << 0.1, -1.0 / 3.0, height;
  return X_WB;
}

/// Log with IMU ticks 0 and 6, frames at 0 (no pose), 20 (ok) and 40 (outlier), and a tracked pose at 12.
FlightLog TurningLog() {
  FlightLog log;
  for (const models::Tick tick : {0, 6}) log.ticks.emplace_back().truth.tick = tick;
  log.ticks[1].truth.X_WB = Turned(1.0);
  log.frames.resize(3);
  log.frames[1].mid_exposure = 20;
  log.frames[1].X_WB = Turned(2.0);
  log.frames[1].status = estimator::FrameStatus::kOk;
  log.frames[1].pose.emplace().X_WB = Turned(2.1);
  log.frames[2].mid_exposure = 40;
  log.frames[2].X_WB = Turned(2.5);
  log.frames[2].status = estimator::FrameStatus::kRejected;
  log.frames[2].pose.emplace().X_WB = Turned(0.1);
  auto& tracking = std::get<std::vector<SensorRecord<sim::TrackingSystem>>>(log.sensors);
  tracking.push_back({.reading = {.tick = 12, .X_WB = Turned(1.6)}, .X_WB = Turned(1.5)});
  return log;
}

TEST(TumTrajectory, ReadsBackToSamePoses) {
  const std::vector<Line> estimate = ReadTum(TumText(EstimatedTrajectory(TurningLog()), {}));
  ASSERT_EQ(estimate.size(), 1u);
  EXPECT_EQ(estimate[0].t_s, 20.0 / 1200.0);
  EXPECT_EQ(estimate[0].p, Turned(2.1).translation());
  EXPECT_TRUE(estimate[0].q.toRotationMatrix().isApprox(Turned(2.1).linear(), 1e-14));
  const std::vector<Line> tracked = ReadTum(TumText(TrackedTrajectory(TurningLog()), {}));
  ASSERT_EQ(tracked.size(), 1u);
  EXPECT_EQ(tracked[0].t_s, 0.01);
  EXPECT_EQ(tracked[0].p.z(), 1.6);
}

TEST(TumTrajectory, HasOneTruePoseAtEachTimeOfTheOtherTrajectories) {
  const std::vector<Line> truth = ReadTum(TumText(TrueTrajectory(TurningLog()), {}));
  std::vector<double> heights;
  std::set<double> times;
  for (const Line& line : truth) {
    EXPECT_TRUE(times.empty() || line.t_s > *times.rbegin());
    times.insert(line.t_s);
    heights.push_back(line.p.z());
  }
  EXPECT_EQ(heights, (std::vector<double>{0.0, 1.0, 1.5, 2.0, 2.5}));
  for (const Line& line : ReadTum(TumText(EstimatedTrajectory(TurningLog()), {})))
    EXPECT_TRUE(times.contains(line.t_s));
  for (const Line& line : ReadTum(TumText(TrackedTrajectory(TurningLog()), {}))) EXPECT_TRUE(times.contains(line.t_s));
}

}  // namespace
}  // namespace touchdown::runner
