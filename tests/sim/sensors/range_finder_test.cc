#include "sim/sensors/range_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "models/angles.h"
#include "models/error.h"
#include "tests/support/nominal.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using tests::kTime;

constexpr double kFloor_m = 1.1e-3;  ///< The sheets of the floor are up to 1 mm below the pad.

RangeFinderConfig Exact() {
  RangeFinderConfig config;
  config.noise_m = 0.0;
  return config;
}

/// First reading of a sensor at X_WB.
std::optional<double> RangeAt(const Eigen::Isometry3d& X_WB, const World& world,
                              const RangeFinderConfig& config = Exact()) {
  RangeFinder sensor(config, world, kTime, 1);
  TrueState truth;
  truth.X_WB = X_WB;
  const auto reading = sensor.Sample(truth);
  if (!reading) return std::nullopt;
  EXPECT_EQ(reading->tick, 0);
  return reading->range_m;
}

TEST(RangeFinder, MeasuresAlongTheBodyAxis) {
  const World world = tests::QuietWorld(tests::kVehicle);
  Eigen::Isometry3d X_WB = tests::LevelPose(1.5, 0.5, 1.2);
  EXPECT_NEAR(RangeAt(X_WB, world).value(), 1.17, kFloor_m);
  X_WB.linear() = models::RotationFromTaitBryan({.roll = DegToRad(20.0), .pitch = 0.0, .yaw = 1.0});
  const double height_m = (X_WB * Exact().position_m).z();
  EXPECT_NEAR(RangeAt(X_WB, world).value(), height_m / std::cos(DegToRad(20.0)), kFloor_m);
}

TEST(RangeFinder, MeasuresToTheTopOfAnObject) {
  Scene scene = tests::EmptyRoom();
  SceneItem box;
  box.kind = SceneItem::Kind::kBox;
  box.size_m = {0.4, 0.4, 0.3};
  box.position_m = {1.5, 0.5};
  scene.items.push_back(box);
  const World world(tests::StillAndBalanced(), tests::kVehicle, scene, kTime, 1);
  EXPECT_NEAR(RangeAt(tests::LevelPose(1.5, 0.5, 1.2), world).value(), 0.87, 1e-9);
  EXPECT_NEAR(RangeAt(tests::LevelPose(2.1, 0.5, 1.2), world).value(), 1.17, kFloor_m);
}

TEST(RangeFinder, HasNoReadingOutsideItsLimits) {
  const World world = tests::QuietWorld(tests::kVehicle);
  RangeFinderConfig config = Exact();
  config.min_range_m = 0.5;
  config.max_range_m = 2.0;
  EXPECT_FALSE(RangeAt(tests::LevelPose(1.5, 0.5, 0.52), world, config));
  EXPECT_TRUE(RangeAt(tests::LevelPose(1.5, 0.5, 0.54), world, config));
  EXPECT_TRUE(RangeAt(tests::LevelPose(1.5, 0.5, 2.02), world, config));
  EXPECT_FALSE(RangeAt(tests::LevelPose(1.5, 0.5, 2.04), world, config));
}

TEST(RangeFinder, HasTheRateAndNoiseOfItsConfig) {
  const World world = tests::QuietWorld(tests::kVehicle);
  RangeFinderConfig config;
  config.noise_m = 0.02;
  RangeFinder sensor(config, world, kTime, 1);
  TrueState truth;
  truth.X_WB = tests::LevelPose(1.5, 0.5, 1.03);
  int count = 0;
  double sum_m = 0.0, sum_m2 = 0.0;
  for (; truth.tick < kTime.FromSeconds(100.0); ++truth.tick) {
    const auto reading = sensor.Sample(truth);
    if (!reading) continue;
    ++count;
    sum_m += reading->range_m - 1.0;
    sum_m2 += (reading->range_m - 1.0) * (reading->range_m - 1.0);
  }
  EXPECT_EQ(count, 5000);
  EXPECT_NEAR(sum_m / count, 0.0, 4.0 * 0.02 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(sum_m2 / count), 0.02, 0.001);
}

TEST(RangeFinder, RejectsInvalidConfigs) {
  RangeFinderConfig config;
  config.rate_hz = 7;
  EXPECT_THROW(config.Validate(kTime), InputError);
  config = {};
  config.min_range_m = config.max_range_m;
  EXPECT_THROW(config.Validate(kTime), InputError);
}

}  // namespace
}  // namespace touchdown::sim
